!> From a job to a body: the control lines with their chains, the sections on them, the joints for
!> the ledger. Here cards and geometry meet; what can't be built is said of its card and left out.
module body_build
    use base_decimal, only: to_real
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use base_text, only: compact
    use body_body, only: body_type, finish_body
    use body_build_lines, only: build_lines
    use body_ledger, only: joint_type
    use body_line, only: line_type
    use body_nose, only: round_nose
    use body_section, only: limit_section, section_type
    use deck_body_card, only: blame
    use deck_job, only: asked_body_type => body_type, asked_section_type => section_type, &
        job_type, origin, side, view
    use geom_arc, only: direction_of_slope
    implicit none (type, external)
    private

    public :: build_body

contains

    !> Builds a body of a job. Lines keep their numbers; sections on a line that can't be built are
    !> left out, and a section of BOTH sides becomes two.
    pure subroutine build_body(job, number, body, joints, faults)
        type(job_type), intent(in) :: job                       !! what the deck asks for
        integer, intent(in) :: number                           !! which of its bodies
        type(body_type), intent(out) :: body                    !! the body
        type(joint_type), allocatable, intent(out) :: joints(:) !! its ledger, line by line
        type(fault_list_type), intent(inout) :: faults          !! what is wrong is added
        integer :: i

        associate (asked => job%body(number))
            body%name = asked%name
            body%is_symmetric = job%is_symmetric
            body%is_closed = job%is_closed
            allocate (joints(0), body%sections(0))
            call build_lines(asked, to_real(job%joint_gap), body%lines, joints, faults)
            if (asked%has_nose) call build_nose(asked, to_real(job%joint_gap), body, joints, faults)
            do i = 1, size(asked%section)
                if (is_buildable(asked, asked%section(i), body%lines)) then
                    call build_section(asked%section(i), body, faults)
                end if
            end do
        end associate
        call finish_body(body)
    end subroutine build_body

    !> Rounds the nose of a body; where that can't be done it stays sharp.
    pure subroutine build_nose(asked, gap, body, joints, faults)
        type(asked_body_type), intent(in) :: asked                  !! as the deck has it
        real(dp), intent(in) :: gap                                 !! by which points may miss
        type(body_type), intent(inout) :: body                      !! with its lines
        type(joint_type), allocatable, intent(inout) :: joints(:)   !! the ledger
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        integer :: before

        before = faults%count
        call round_nose(asked, gap, body%lines, joints, faults)
        body%has_nose = .not. faults%has_errors(before)
        if (body%has_nose) body%nose_radius = to_real(asked%nose_radius)
    end subroutine build_nose

    !> True where a section and all views it stands on are sound. (Where they are not, that was
    !> said of their cards.)
    pure logical function is_buildable(asked, section, lines)
        type(asked_body_type), intent(in) :: asked          !! as the deck has it
        type(asked_section_type), intent(in) :: section     !! one of its sections
        type(line_type), intent(in) :: lines(:)             !! its lines
        integer :: i

        is_buildable = section%is_sound
        if (.not. is_buildable) return
        do i = 1, 3
            associate (number => section%line(i))
                is_buildable = is_buildable .and. lines(number)%has_side .and. &
                    (lines(number)%has_plan .or. &
                    asked%line(number)%view(view%plan)%origin == origin%none)
            end associate
        end do
        do i = 1, 2
            if (.not. section%slope(i)%is_angle) cycle
            is_buildable = is_buildable .and. lines(section%slope(i)%line)%has_angle
        end do
    end function is_buildable

    !> Puts a section to a body, where there is a stretch of stations for it.
    pure subroutine build_section(asked, body, faults)
        type(asked_section_type), intent(in) :: asked   !! as the deck has it
        type(body_type), intent(inout) :: body          !! with its lines
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added
        type(section_type) :: item, limited
        integer :: i

        item%name = asked%name
        item%line = asked%line
        do i = 1, 2
            item%slope(i)%is_angle = asked%slope(i)%is_angle
            item%slope(i)%line = asked%slope(i)%line
            if (.not. item%slope(i)%is_angle) then
                item%slope(i)%direction = direction_of_slope(to_real(asked%slope(i)%value))
            end if
        end do
        item%from = -huge(1.0_dp)
        item%to = huge(1.0_dp)
        if (asked%range%has_from) item%from = to_real(asked%range%from)
        if (asked%range%has_to) item%to = to_real(asked%range%to)
        limited = item
        call limit_section(body%lines, limited)
        if (.not. limited%from < limited%to) then
            call blame_stretch(asked, limited, body%lines, faults)
        else if (limited%from <= -huge(1.0_dp) .or. limited%to >= huge(1.0_dp)) then
            call blame(asked%card, 2, 'all lines of section '//trim(item%name)// &
                ' are constants without an end; say FROM and TO in fields 8 and 9', faults)
        else
            item%is_port = asked%side == side%port
            body%sections = [body%sections, item]
            if (asked%side /= side%both) return
            item%is_port = .true.
            body%sections = [body%sections, item]
        end if
    end subroutine build_section

    !> Why a section has no stretch of stations: the ranges of its lines.
    pure subroutine blame_stretch(asked, section, lines, faults)
        type(asked_section_type), intent(in) :: asked   !! as the deck has it
        type(section_type), intent(in) :: section       !! drawn in to its lines
        type(line_type), intent(in) :: lines(:)         !! of the body
        type(fault_list_type), intent(inout) :: faults  !! gets the fault
        character(:), allocatable :: words
        integer :: i

        words = 'section '//trim(section%name)//' has no stretch of stations: '
        do i = 1, 3
            associate (line => lines(section%line(i)))
                words = words//trim(line%name)//' is '
                if (line%from > -huge(1.0_dp)) then
                    words = words//'from '//compact(line%from)//' to '//compact(line%to)//', '
                else
                    words = words//'a constant, '
                end if
            end associate
        end do
        words = words//'drawn in to its own range and slopes nothing is left; lengthen a line, '// &
            'or correct FROM and TO'
        call blame(asked%card, 2, words, faults)
    end subroutine blame_stretch

end module body_build
