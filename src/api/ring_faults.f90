!> What is wrong with the way sections of a body go round it: a skin that breaks where two of them
!> meet on a line that is no chine, a chine on which it does not, and ends that meet nothing though
!> the deck says CLOSE.
module api_ring_faults
    use base_fault, only: fault_list_type
    use base_text, only: compact
    use body_body, only: body_type
    use body_ring_end, only: is_on_chine, line_of_end, name_of_end, section_of
    use body_ring_list, only: is_broken, loose_end_type, meeting_type, ring_type
    use deck_body_card, only: warn
    use deck_job, only: asked_body_type => body_type
    implicit none (type, external)
    private

    public :: warn_of_ring

contains

    !> Warns of breaks over `tangency_tolerance` but on chines, of chines without one and, where the
    !> body is to be closed, of loose ends. Of a section on both sides only the starboard one is
    !> spoken of.
    subroutine warn_of_ring(asked, body, ring, faults)
        type(asked_body_type), intent(in) :: asked      !! as the deck has it
        type(body_type), intent(in) :: body             !! as built
        type(ring_type), intent(in) :: ring             !! of the body
        type(fault_list_type), intent(inout) :: faults  !! warnings are added
        character(:), allocatable :: words
        integer :: i

        do i = 1, size(ring%meetings)
            associate (meeting => ring%meetings(i))
                if (.not. is_broken(meeting)) cycle
                if (is_image(body, meeting%end) .or. is_meant(body, meeting)) cycle
                call say_break(body, meeting, words)
                call warn_of_section(asked, body, maxval(meeting%end), words, faults)
            end associate
        end do
        if (.not. faults%has_errors(0)) call warn_of_chines(asked, body, ring, faults)
        if (.not. body%is_closed) return
        do i = 1, size(ring%loose)
            if (is_image(body, [ring%loose(i)%end])) cycle
            call say_loose_end(body, ring%loose(i), words)
            call warn_of_section(asked, body, ring%loose(i)%end, words, faults)
        end do
    end subroutine warn_of_ring

    !> Warns of lines said to be chines on which the skin does not break.
    subroutine warn_of_chines(asked, body, ring, faults)
        type(asked_body_type), intent(in) :: asked      !! as the deck has it
        type(body_type), intent(in) :: body             !! as built
        type(ring_type), intent(in) :: ring             !! of the body
        type(fault_list_type), intent(inout) :: faults  !! warnings are added
        logical :: breaks(size(asked%line))
        integer :: i, k

        breaks = .false.
        do i = 1, size(ring%meetings)
            if (.not. is_broken(ring%meetings(i))) cycle
            do k = 1, 2
                if (ring%meetings(i)%end(k) == 0) cycle
                breaks = breaks .or. asked%line%name == line_of_end(body, ring%meetings(i)%end(k))
            end do
        end do
        do i = 1, size(breaks)
            if (breaks(i) .or. .not. allocated(asked%line(i)%chine)) cycle
            call warn(asked%line(i)%chine, 2, 'on '//trim(asked%line(i)%name)// &
                ' the skin does not break: no two sections meet there at an angle; CHINE says '// &
                'nothing', faults)
        end do
    end subroutine warn_of_chines

    !> True for a break on a chine.
    pure logical function is_meant(body, meeting)
        type(body_type), intent(in) :: body         !! as built
        type(meeting_type), intent(in) :: meeting   !! any
        is_meant = is_on_chine(body, meeting%end(1))
        if (meeting%end(2) > 0) is_meant = is_meant .or. is_on_chine(body, meeting%end(2))
    end function is_meant

    !> True where all ends are of port sections whose starboard originals stand before them.
    pure logical function is_image(body, ends)
        type(body_type), intent(in) :: body !! as built
        integer, intent(in) :: ends(:)      !! as `body_ring_end` counts; 0: mirror image
        integer :: i, number

        is_image = .true.
        do i = 1, size(ends)
            if (ends(i) == 0) cycle
            number = section_of(ends(i))
            is_image = is_image .and. body%sections(number)%is_port .and. &
                any(body%sections(:number - 1)%name == body%sections(number)%name)
        end do
    end function is_image

    !> Warns on the card of the section of an end.
    subroutine warn_of_section(asked, body, end, message, faults)
        type(asked_body_type), intent(in) :: asked      !! as the deck has it
        type(body_type), intent(in) :: body             !! as built
        integer, intent(in) :: end                      !! as `body_ring_end` counts
        character(*), intent(in) :: message             !! what the user will want to know
        type(fault_list_type), intent(inout) :: faults  !! gets the warning
        integer :: i

        do i = 1, size(asked%section)
            if (asked%section(i)%name /= body%sections(section_of(end))%name) cycle
            call warn(asked%section(i)%card, 2, message, faults)
            return
        end do
    end subroutine warn_of_section

    !> Says a break in words.
    pure subroutine say_break(body, meeting, words)
        type(body_type), intent(in) :: body             !! as built
        type(meeting_type), intent(in) :: meeting       !! broken
        character(:), allocatable, intent(out) :: words !! the sentence

        words = 'on '//line_of_end(body, meeting%end(1))//' the skin breaks by up to '// &
            compact(meeting%break)//' degrees, at station '//compact(meeting%sta)//', between '// &
            name_of_end(body, meeting%end(1))
        if (meeting%end(2) > 0) then
            words = words//' and '//name_of_end(body, meeting%end(2))// &
                '; give both the same slope, or say CHINE on its LINE card where an '// &
                'edge is meant'
        else
            words = words//' and its mirror image; make its slope there 0., or say CHINE '// &
                'on its LINE card where an edge is meant'
        end if
    end subroutine say_break

    !> Says a loose end in words.
    pure subroutine say_loose_end(body, loose, words)
        type(body_type), intent(in) :: body             !! as built
        type(loose_end_type), intent(in) :: loose       !! end of one of its sections
        character(:), allocatable, intent(out) :: words !! the sentence

        words = 'from station '//compact(loose%from)//' to '//compact(loose%to)//' section '// &
            name_of_end(body, loose%end)//' meets no other on '//line_of_end(body, loose%end)
        if (loose%next > 0) words = words//' ('//name_of_end(body, loose%next)//' on '// &
            line_of_end(body, loose%next)//' is up to '//compact(norm2(loose%gap))//' away, at '// &
            'station '//compact(loose%sta)//')'
        words = words//', so that the body is not closed; let two sections share the line, or '// &
            'take CLOSE out'
    end subroutine say_loose_end

end module api_ring_faults
