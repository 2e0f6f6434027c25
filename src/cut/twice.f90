!> The second way to every point of a cut, which shares nothing with the first but the control
!> lines: the section as an implicit conic, its zero bracketed and closed in upon across the
!> outline, in the plane of the cut.
module cut_twice
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_tolerances, only: decimal_noise, ulp
    use body_body, only: body_type
    use body_line, only: line_type
    use body_section, only: section_type, trace_at, trace_type
    use cut_outline, only: cut_point_type, outline_type
    use cut_plane, only: plane_type
    use geom_vector, only: cross
    use geom_zeros, only: function_type, zero_between
    implicit none (type, external)
    private

    public :: largest_disagreement, distance_between_ways

    !> The implicit conic of a section along a straight way through space.
    type, extends(function_type) :: way_type
        type(line_type), allocatable :: lines(:)    !! of the body
        type(section_type) :: section               !! one of its sections
        real(dp) :: from(3) = 0.0_dp                !! STA, BL, WL, deck units
        real(dp) :: along(3) = 0.0_dp               !! unit vector
        real(dp) :: size = 1.0_dp                   !! a length of the section, deck units
        logical :: is_straight = .false.            !! the section is a straight line
    contains
        procedure :: at => value_along
    end type way_type

    !> The bracket about a point, as a share of the section's chord.
    real(dp), parameter :: bracket = 1.0e-5_dp

contains

    !> The largest distance between the two ways at any point of some outlines, deck units. Points
    !> without a slope, at a point nose, are left out.
    pure real(dp) function largest_disagreement(body, plane, outlines) result(largest)
        type(body_type), intent(in) :: body             !! finished
        type(plane_type), intent(in) :: plane           !! of the cut
        type(outline_type), intent(in) :: outlines(:)   !! of both
        integer :: i, k

        largest = 0.0_dp
        do i = 1, size(outlines)
            do k = 1, size(outlines(i)%points)
                associate (point => outlines(i)%points(k))
                    if (.not. point%has_slope) cycle
                    largest = max(largest, distance_between_ways(body, plane, point))
                end associate
            end do
        end do
    end function largest_disagreement

    !> The distance between the two ways at a point, across the outline.
    pure real(dp) function distance_between_ways(body, plane, point) result(distance)
        type(body_type), intent(in) :: body         !! finished
        type(plane_type), intent(in) :: plane       !! of the cut
        type(cut_point_type), intent(in) :: point   !! of both, with a slope
        type(way_type) :: way
        real(dp) :: reach, edge(2), here, there

        way = across_outline(body, plane, point)
        distance = 0.0_dp
        if (is_zero(way%size)) return
        reach = bracket*way%size
        edge = [-reach, reach]
        if (.not. is_in_range(way, edge(1))) edge(1) = 0.0_dp
        if (.not. is_in_range(way, edge(2))) edge(2) = 0.0_dp
        here = way%at(edge(1))
        there = way%at(edge(2))
        if (here*there < 0.0_dp) then
            distance = abs(zero_between(way, edge(1), edge(2)))
        else if (abs(there - here) > 0.0_dp) then
            distance = min(abs(here), abs(there))/abs(there - here)*(edge(2) - edge(1))
        end if
    end function distance_between_ways

    !> The way through a point across its outline.
    pure type(way_type) function across_outline(body, plane, point) result(way)
        type(body_type), intent(in) :: body         !! finished
        type(plane_type), intent(in) :: plane       !! of the cut
        type(cut_point_type), intent(in) :: point   !! of both, with a slope
        type(trace_type) :: trace
        real(dp) :: chord(2), rise

        allocate (way%lines(0))
        way%lines = body%lines
        way%section = body%sections(point%section)
        way%from = point%at
        way%along = plane%u
        if (.not. point%slope%is_vertical) way%along = plane%v - point%slope%value*plane%u
        way%along = way%along/norm2(way%along)
        trace = trace_at(way%lines, way%section, point%at(1))
        chord = trace%finish%point - trace%start%point
        way%size = maxval(abs(chord))
        rise = cross(trace%shoulder - trace%start%point, chord)
        way%is_straight = abs(rise) <= decimal_noise*ulp*way%size &
            *maxval(abs([trace%start%point, trace%shoulder, trace%finish%point]))
    end function across_outline

    !> True where the section is at a distance along a way.
    pure logical function is_in_range(way, distance)
        type(way_type), intent(in) :: way       !! any
        real(dp), intent(in) :: distance        !! deck units
        real(dp) :: sta
        sta = way%from(1) + distance*way%along(1)
        is_in_range = sta >= way%section%from .and. sta <= way%section%to
    end function is_in_range

    !> The implicit conic at a distance along a way: F of `body_surface`, in numbers.
    pure real(dp) function value_along(f, x) result(value)
        class(way_type), intent(in) :: f    !! the way
        real(dp), intent(in) :: x           !! distance, deck units
        type(trace_type) :: trace
        real(dp) :: at(3)
        real(dp), dimension(2) :: chord, start, finish, shoulder, beyond

        at = f%from + x*f%along
        trace = trace_at(f%lines, f%section, at(1))
        chord = (trace%finish%point - trace%start%point)/f%size
        start = (at(2:) - trace%start%point)/f%size
        finish = (at(2:) - trace%finish%point)/f%size
        shoulder = (trace%shoulder - trace%start%point)/f%size
        beyond = (trace%shoulder - trace%finish%point)/f%size
        value = cross(start, chord)
        if (f%is_straight) return
        associate (first => trace%start%tangent, last => trace%finish%tangent)
            value = value**2*cross(shoulder, first)*cross(beyond, last) &
                - cross(start, first)*cross(finish, last)*cross(shoulder, chord)**2
        end associate
    end function value_along

end module cut_twice
