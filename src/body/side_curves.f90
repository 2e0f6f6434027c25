!> The curves that the sides of a patch may be parts of, each whole: a line, the arcs of all
!> sections at a station, all that a cut takes from the skin.
module body_side_curves
    use base_decimal, only: to_real
    use base_error, only: cause, error_type, fail
    use base_kinds, only: dp
    use base_text, only: compact, to_text, widest_compact
    use body_line, only: line_type
    use body_panel_side, only: line_side, side_type
    use body_trace, only: arcs_at, trace_type, world_type
    use deck_job, only: bound, name_length, patch_type
    implicit none (type, external)
    private

    public :: list_curves, side_words

contains

    !> The curves that a side may be a part of. Fails with `cause%beyond_lines` where there are
    !> none.
    pure subroutine list_curves(asked, number, world, curve, error)
        type(patch_type), intent(in) :: asked                       !! the patch
        integer, intent(in) :: number                               !! which side; no POINT
        type(world_type), intent(in) :: world                       !! lines, sections, cuts
        type(side_type), allocatable, intent(out) :: curve(:)       !! whole
        type(error_type), allocatable, intent(out) :: error         !! see above
        type(trace_type), allocatable :: found(:)
        type(side_type) :: whole
        real(dp) :: ends(2)
        integer :: i

        allocate (curve(0), found(0))
        associate (side => asked%side(number), lines => world%body%lines)
            if (side%kind == bound%line) then
                ends = reach_of(lines, asked)
                ends = [max(ends(1), lines(side%line)%from), min(ends(2), lines(side%line)%to)]
                if (asked%range%has_from) ends(1) = max(ends(1), to_real(asked%range%from))
                if (asked%range%has_to) ends(2) = min(ends(2), to_real(asked%range%to))
                if (ends(1) < ends(2)) then
                    whole = line_side(lines(side%line), ends(1), ends(2))
                    curve = [whole]
                else
                    call fail(error, cause%beyond_lines, 'is nowhere between FROM and TO, or '// &
                        'where the other lines are')
                end if
                return
            end if
            if (side%kind == bound%station) found = arcs_at(world%body, to_real(side%station))
            if (side%kind == bound%cut) found = &
                pack(world%traces, world%traces%cut == side%cut)
        end associate
        do i = 1, size(found)
            curve = [curve, found(i)%side]
        end do
        if (size(curve) == 0) call fail(error, cause%beyond_lines, &
            'meets no section: there is no curve of it on the skin')
    end subroutine list_curves

    !> The stations that a patch may reach: those of lines that end, and of its own sides. A line of
    !> one ordinate alone has no ends.
    pure function reach_of(lines, asked) result(reach)
        type(line_type), intent(in) :: lines(:)     !! of the body
        type(patch_type), intent(in) :: asked       !! the patch
        real(dp) :: reach(2)
        integer :: i

        reach = [huge(1.0_dp), -huge(1.0_dp)]
        do i = 1, size(lines)
            if (lines(i)%from > -huge(1.0_dp)) reach(1) = min(reach(1), lines(i)%from)
            if (lines(i)%to < huge(1.0_dp)) reach(2) = max(reach(2), lines(i)%to)
        end do
        do i = 1, 4
            if (asked%side(i)%kind /= bound%station) cycle
            reach(1) = min(reach(1), to_real(asked%side(i)%station))
            reach(2) = max(reach(2), to_real(asked%side(i)%station))
        end do
    end function reach_of

    !> What a side is, in words.
    pure function side_words(asked, world, number) result(words)
        type(patch_type), intent(in) :: asked       !! the patch
        type(world_type), intent(in) :: world       !! names of lines and cuts
        integer, intent(in) :: number               !! which side
        character(32 + max(name_length, widest_compact)) :: words

        words = 'side '//to_text(number)
        associate (side => asked%side(number))
            select case (side%kind)
            case (bound%line)
                words = trim(words)//' (line '//trim(world%body%lines(side%line)%name)//')'
            case (bound%cut)
                words = trim(words)//' (cut '//trim(world%asked%cut(side%cut)%name)//')'
            case (bound%station)
                words = trim(words)//' (station '//compact(to_real(side%station))//')'
            end select
        end associate
    end function side_words

end module body_side_curves
