!> The second way to every point of a cut, which shares nothing with the first but the control
!> lines: the section as an implicit conic, in a bracket across the outline, in the plane of the
!> cut. How far its zero is from the point is told by the chord of the bracket, and where that is
!> not next to nothing by closing in upon the zero.
module cut_twice
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_tolerances, only: decimal_noise, ulp
    use body_body, only: body_type
    use body_line, only: line_type
    use body_section, only: section_type, trace_at, trace_type
    use body_section_row, only: traces_at
    use cut_outline, only: cut_point_type, outline_type
    use cut_plane, only: plane_type
    use geom_vector, only: cross
    use geom_zeros, only: function_type, zero_between
    implicit none (type, external)
    private

    public :: largest_disagreement, distance_between_ways

    !> A straight way through a point across its outline.
    type :: path_type
        real(dp) :: from(3) = 0.0_dp                !! STA, BL, WL, deck units
        real(dp) :: along(3) = 0.0_dp               !! unit vector
        real(dp) :: size = 1.0_dp                   !! a length of the section, deck units
        logical :: is_straight = .false.            !! the section is a straight line
        real(dp) :: ends(2) = 0.0_dp                !! of the bracket: distances, deck units
    end type path_type

    !> The implicit conic of a section along a way.
    type, extends(function_type) :: way_type
        type(line_type), allocatable :: lines(:)    !! of the body
        type(section_type) :: section               !! one of its sections
        type(path_type) :: path                     !! the way
    contains
        procedure :: at => value_along
    end type way_type

    !> The bracket about a point, as a share of the section's chord.
    real(dp), parameter :: bracket = 1.0e-5_dp
    !> Points that are looked at together.
    integer, parameter :: block = 512
    !> The distance by a chord through the bracket, as a share of it, from which on the zero itself
    !> is looked for.
    real(dp), parameter :: doubtful = 1.0e-8_dp

contains

    !> The largest distance between the two ways at any point of some outlines, deck units. Points
    !> without a slope, at a point nose, are left out.
    pure real(dp) function largest_disagreement(body, plane, outlines) result(largest)
        type(body_type), intent(in) :: body             !! finished
        type(plane_type), intent(in) :: plane           !! of the cut
        type(outline_type), intent(in) :: outlines(:)   !! of both
        integer :: i, first, last

        largest = 0.0_dp
        do i = 1, size(outlines)
            first = 1
            do while (first <= size(outlines(i)%points))
                last = first
                do while (last < min(size(outlines(i)%points), first + block - 1))
                    associate (points => outlines(i)%points)
                        if (points(last + 1)%section /= points(first)%section) exit
                    end associate
                    last = last + 1
                end do
                largest = max(largest, &
                    largest_of_section(body, plane, outlines(i)%points(first:last)))
                first = last + 1
            end do
        end do
    end function largest_disagreement

    !> The largest distance at some points of one section: by the chord of the implicit conic from
    !> one end of the bracket to the other, and where that is not next to nothing by its zero.
    pure real(dp) function largest_of_section(body, plane, points) result(largest)
        type(body_type), intent(in) :: body                 !! finished
        type(plane_type), intent(in) :: plane               !! of the cut
        type(cut_point_type), intent(in) :: points(:)       !! of both, a block or less
        type(trace_type) :: trace(size(points)), trace_1(size(points)), trace_2(size(points))
        type(path_type) :: path(size(points))
        real(dp) :: ends(2), middle, distance
        integer :: i

        largest = 0.0_dp
        associate (section => body%sections(points(1)%section))
            call traces_at(body%lines, section, points%at(1), trace)
            do i = 1, size(points)
                path(i) = across_outline(section, trace(i), plane, points(i))
            end do
            call traces_at(body%lines, section, path%from(1) + path%ends(1)*path%along(1), &
                trace_1)
            call traces_at(body%lines, section, path%from(1) + path%ends(2)*path%along(1), &
                trace_2)
        end associate
        do i = 1, size(points)
            if (.not. points(i)%has_slope .or. is_zero(path(i)%size)) cycle
            middle = value_of(path(i), trace(i), 0.0_dp)
            ends = [value_of(path(i), trace_1(i), path(i)%ends(1)), &
                value_of(path(i), trace_2(i), path(i)%ends(2))]
            distance = huge(1.0_dp)
            if (abs(ends(2) - ends(1)) > 0.0_dp) &
                distance = abs(middle/(ends(2) - ends(1))) &
                    *(path(i)%ends(2) - path(i)%ends(1))
            if (distance > doubtful*bracket*path(i)%size) &
                distance = distance_between_ways(body, plane, points(i))
            largest = max(largest, distance)
        end do
    end function largest_of_section

    !> The distance between the two ways at a point, across the outline.
    pure real(dp) function distance_between_ways(body, plane, point) result(distance)
        type(body_type), intent(in) :: body         !! finished
        type(plane_type), intent(in) :: plane       !! of the cut
        type(cut_point_type), intent(in) :: point   !! of both, with a slope
        type(way_type) :: way
        real(dp) :: here, there

        allocate (way%lines(0))
        way%lines = body%lines
        way%section = body%sections(point%section)
        way%path = across_outline(way%section, trace_at(way%lines, way%section, point%at(1)), &
            plane, point)
        distance = 0.0_dp
        if (is_zero(way%path%size)) return
        associate (edge => way%path%ends)
            here = way%at(edge(1))
            there = way%at(edge(2))
            if (here*there < 0.0_dp) then
                distance = abs(zero_between(way, edge(1), edge(2)))
            else if (abs(there - here) > 0.0_dp) then
                distance = min(abs(here), abs(there))/abs(there - here)*(edge(2) - edge(1))
            end if
        end associate
    end function distance_between_ways

    !> The way through a point across its outline, and its bracket, which ends where the section
    !> does.
    pure type(path_type) function across_outline(section, trace, plane, point) result(path)
        type(section_type), intent(in) :: section   !! of the point
        type(trace_type), intent(in) :: trace       !! of the section at the point
        type(plane_type), intent(in) :: plane       !! of the cut
        type(cut_point_type), intent(in) :: point   !! of all
        real(dp) :: chord(2), rise, sta
        integer :: i

        path%from = point%at
        path%along = plane%u
        if (.not. point%slope%is_vertical) path%along = plane%v - point%slope%value*plane%u
        path%along = path%along/norm2(path%along)
        chord = trace%finish%point - trace%start%point
        path%size = maxval(abs(chord))
        rise = cross(trace%shoulder - trace%start%point, chord)
        path%is_straight = abs(rise) <= decimal_noise*ulp*path%size &
            *maxval(abs([trace%start%point, trace%shoulder, trace%finish%point]))
        do i = 1, 2
            path%ends(i) = real(2*i - 3, dp)*bracket*path%size
            sta = path%from(1) + path%ends(i)*path%along(1)
            if (sta < section%from .or. sta > section%to) path%ends(i) = 0.0_dp
        end do
    end function across_outline

    !> The implicit conic at a distance along a way.
    pure real(dp) function value_along(f, x) result(value)
        class(way_type), intent(in) :: f    !! the way
        real(dp), intent(in) :: x           !! distance, deck units
        value = value_of(f%path, trace_at(f%lines, f%section, f%path%from(1) &
            + x*f%path%along(1)), x)
    end function value_along

    !> The implicit conic at a distance along a way: F of `body_surface`, in numbers.
    pure real(dp) function value_of(path, trace, x) result(value)
        type(path_type), intent(in) :: path     !! the way
        type(trace_type), intent(in) :: trace   !! of the section there
        real(dp), intent(in) :: x               !! distance, deck units
        real(dp), dimension(2) :: at, chord, start, finish, shoulder, beyond

        at = path%from(2:) + x*path%along(2:)
        chord = (trace%finish%point - trace%start%point)/path%size
        start = (at - trace%start%point)/path%size
        finish = (at - trace%finish%point)/path%size
        shoulder = (trace%shoulder - trace%start%point)/path%size
        beyond = (trace%shoulder - trace%finish%point)/path%size
        value = cross(start, chord)
        if (path%is_straight) return
        associate (first => trace%start%tangent, last => trace%finish%tangent)
            value = value**2*cross(shoulder, first)*cross(beyond, last) &
                - cross(start, first)*cross(finish, last)*cross(shoulder, chord)**2
        end associate
    end function value_of

end module cut_twice
