!> From the LINE cards of a body to its control lines, with their joints for the ledger.
module body_build_lines
    use base_decimal, only: to_real
    use base_fault, only: fault_list_type
    use base_kinds, only: dp, i64
    use base_text, only: compact, compact_length
    use body_build_points, only: build_points
    use body_build_view, only: build_view
    use body_ledger, only: joint_type
    use body_line, only: limit_line, line_type
    use deck_body_card, only: blame
    use deck_job, only: body_type, control_line_type, origin, view
    use geom_chain, only: chain_from, chain_to, chain_type, constant_chain
    implicit none (type, external)
    private

    public :: build_lines

    !> The chain of one view of a line.
    type :: holder_type
        type(chain_type), allocatable :: chain !! where the view is given and sound
    end type holder_type

contains

    !> Builds the control lines of a body. A line keeps its number; a view that is not given, or not
    !> sound, it has not (`has_side`, `has_plan`, `has_angle`). What is wrong is said of its card,
    !> as `build_view` does; besides, of a line whose side and plan view have no station in common.
    pure subroutine build_lines(body, gap, lines, joints, faults)
        type(body_type), intent(in) :: body                         !! as the deck has it
        real(dp), intent(in) :: gap                                 !! largest gap at a joint
        type(line_type), allocatable, intent(out) :: lines(:)       !! as many as the body has
        type(joint_type), allocatable, intent(inout) :: joints(:)   !! the ledger
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        type(holder_type) :: views(3, size(body%line))
        integer :: i

        allocate (lines(size(body%line)))
        call build_own_views(body, gap, views, joints, faults)
        call take_views_over(body, views)
        do i = 1, size(lines)
            call put_together(body%line(i), views(:, i), lines(i), faults)
        end do
    end subroutine build_lines

    !> The views that have data cards of their own, or are constant.
    pure subroutine build_own_views(body, gap, views, joints, faults)
        type(body_type), intent(in) :: body                         !! as the deck has it
        real(dp), intent(in) :: gap                                 !! largest gap at a joint
        type(holder_type), intent(inout) :: views(:, :)             !! shape (3, lines)
        type(joint_type), allocatable, intent(inout) :: joints(:)   !! the ledger
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        integer :: i, j

        do i = 1, size(body%line)
            do j = 1, 3
                associate (given => body%line(i)%view(j))
                    if (.not. given%is_sound) cycle
                    select case (given%origin)
                    case (origin%pieces)
                        call build_view(body%line(i), j, gap, views(j, i)%chain, joints, faults)
                    case (origin%spline, origin%bezier, origin%fair)
                        call build_points(given, gap, views(j, i)%chain, faults)
                    case (origin%constant)
                        allocate (views(j, i)%chain)
                        call constant_chain(to_real(given%constant), views(j, i)%chain)
                    end select
                end associate
            end do
        end do
    end subroutine build_own_views

    !> The views that are taken over from other lines, also from such as took theirs over.
    pure subroutine take_views_over(body, views)
        type(body_type), intent(in) :: body             !! as the deck has it
        type(holder_type), intent(inout) :: views(:, :) !! shape (3, lines), the others built
        integer :: i, j, from

        do i = 1, size(body%line)
            do j = 1, 3
                from = source_of(body, i, j)
                if (from == 0 .or. from == i) cycle
                if (allocated(views(j, from)%chain)) views(j, i)%chain = views(j, from)%chain
            end do
        end do
    end subroutine take_views_over

    !> The line from which a view comes in the end, itself where it was not taken over; 0 where that
    !> was not found. A view is taken over from one given before it, so that this comes to an end.
    pure integer function source_of(body, line, which) result(source)
        type(body_type), intent(in) :: body !! as the deck has it
        integer, intent(in) :: line         !! the line
        integer, intent(in) :: which        !! one of `view%...`

        source = line
        do while (source > 0)
            if (body%line(source)%view(which)%origin /= origin%line) exit
            source = body%line(source)%view(which)%line
        end do
    end function source_of

    !> A line from its views.
    pure subroutine put_together(asked, views, line, faults)
        type(control_line_type), intent(in) :: asked    !! as the deck has it
        type(holder_type), intent(in) :: views(3)       !! its views
        type(line_type), intent(out) :: line            !! the line
        type(fault_list_type), intent(inout) :: faults  !! what is wrong is added

        line%name = asked%name
        line%is_chine = allocated(asked%chine)
        line%has_side = allocated(views(view%side)%chain)
        line%has_plan = allocated(views(view%plan)%chain)
        line%has_angle = allocated(views(view%angle)%chain)
        call constant_chain(0.0_dp, line%plan)
        if (line%has_side) line%side = views(view%side)%chain
        if (line%has_plan) line%plan = views(view%plan)%chain
        if (line%has_angle) line%angle = views(view%angle)%chain
        if (.not. (line%has_side .or. line%has_plan .or. line%has_angle)) return
        call limit_line(line)
        if (line%from <= line%to) return
        call blame(asked%view(view%plan)%card, 2, 'the side view of '//trim(line%name)//' is '// &
            range_words(line%side)//', its plan view '//range_words(line%plan)// &
            '; they have no station in common', faults)
        line%has_side = .false.
        line%has_plan = .false.
    end subroutine put_together

    !> The range of a view that is no constant, in words.
    pure function range_words(chain) result(words)
        type(chain_type), intent(in) :: chain !! any chain with ends
        character(9_i64 + compact_length(chain_from(chain)) + &
            compact_length(chain_to(chain))) :: words
        words = 'from '//compact(chain_from(chain))//' to '//compact(chain_to(chain))
    end function range_words

end module body_build_lines
