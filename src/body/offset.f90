!> The inside of a skin: the points Q - t n(Q), Q on the outside and n its outward normal.
!>
!> From a point on the outside a straight way leads inwards, and where it meets the inside is solved
!> for with Newton's method on Q, in which the change of the normal is that of the surface:
!> dn = W dQ, W the Weingarten map. The thickness is brought up in steps.
!>
!> Source: M. P. do Carmo, "Differential Geometry of Curves and Surfaces", 1976, 3.2 (Weingarten
!> map), 3.5 exercise 11 (parallel surfaces: curvatures k/(1 - t k)).
module body_offset
    use base_error, only: error_type
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_section, only: section_arc, section_type, trace_at, trace_type
    use body_surface, only: form_along, gradient_at, patch_at, patch_type
    use body_taylor, only: taylor_type
    use geom_arc, only: arc_type
    use geom_space, only: across
    use geom_vector, only: cross
    implicit none (type, external)
    private

    public :: foot_type, foot_at, way_inside, steepest_curvature, parallel_curvature
    public :: settle_inside, is_on_section

    !> A point of the outside of the skin.
    type :: foot_type
        integer :: section = 0              !! in the body's list
        real(dp) :: at(3) = 0.0_dp          !! STA, BL, WL, deck units
        real(dp) :: normal(3) = 0.0_dp      !! outward, of unit length
        real(dp) :: axes(3, 2) = 0.0_dp     !! two unit vectors along the skin, across each other
        real(dp) :: bend(2, 2) = 0.0_dp     !! W in these axes, 1/deck unit; positive is convex
    end type foot_type

    !> Steps in which the thickness is brought up.
    integer, parameter :: stages = 8
    !> Newton steps of a stage; the last ones repeat what rounding allows.
    integer, parameter :: most_steps = 30
    !> Steps along the normal that bring a point onto a conic.
    integer, parameter :: foot_steps = 6
    !> A step below this part of the thickness is rounding.
    real(dp), parameter :: step_noise = 1.0e-9_dp
    !> How far beyond an edge of its section a point may be and still be of it, as a share.
    real(dp), parameter :: edge_noise = 1.0e-9_dp

contains

    !> The outside next to a point, on the conics of a section (also beyond its edges). False where
    !> the section is not there, or has no smooth surface.
    pure subroutine foot_at(body, section, near, outwards, foot, is_there)
        type(body_type), intent(in) :: body         !! finished
        integer, intent(in) :: section              !! which of its sections
        real(dp), intent(in) :: near(3)             !! STA, BL, WL, deck units
        real(dp), intent(in) :: outwards(3)         !! a vector on the outer side
        type(foot_type), intent(out) :: foot        !! on the surface
        logical, intent(out) :: is_there            !! see above
        type(patch_type) :: patch
        real(dp) :: gradient(3), step
        type(taylor_type) :: form
        integer :: i

        foot%section = section
        foot%at = near
        do i = 1, foot_steps
            call look(body, section, foot%at(1), patch, is_there)
            if (.not. is_there) return
            gradient = gradient_at(patch, foot%at(2:))
            is_there = any(.not. is_zero(gradient))
            if (.not. is_there) return
            foot%normal = gradient/norm2(gradient)
            form = form_along(patch, foot%at(2:), foot%normal)
            is_there = .not. is_zero(form%first)
            if (.not. is_there) return
            step = -form%value/form%first
            foot%at = foot%at + step*foot%normal
        end do
        if (dot_product(foot%normal, outwards) < 0.0_dp) foot%normal = -foot%normal
        call measure_bend(patch, foot)
    end subroutine foot_at

    !> A section about a station.
    pure subroutine look(body, section, sta, patch, is_there)
        type(body_type), intent(in) :: body         !! finished
        integer, intent(in) :: section              !! which of its sections
        real(dp), intent(in) :: sta                 !! deck units
        type(patch_type), intent(out) :: patch      !! where there is one
        logical, intent(out) :: is_there            !! the section is there and smooth
        type(arc_type) :: arc
        type(error_type), allocatable :: error

        associate (it => body%sections(section))
            is_there = sta >= it%from .and. sta <= it%to
            if (.not. is_there) return
            call section_arc(body%lines, it, sta, arc, error)
            is_there = .not. allocated(error)
            if (.not. is_there) return
            patch = patch_at(body%lines, it, sta, arc)
            is_there = .not. any(patch%is_vertical)
        end associate
    end subroutine look

    !> Axes along the skin and the Weingarten map in them: second derivatives of F over its slope.
    pure subroutine measure_bend(patch, foot)
        type(patch_type), intent(in) :: patch       !! about the foot
        type(foot_type), intent(inout) :: foot      !! has point and normal
        type(taylor_type) :: form
        real(dp) :: diagonal(3), slope
        integer :: thinnest

        thinnest = minloc(abs(foot%normal), dim=1)
        foot%axes(:, 1) = 0.0_dp
        foot%axes(thinnest, 1) = 1.0_dp
        foot%axes(:, 1) = foot%axes(:, 1) - foot%normal(thinnest)*foot%normal
        foot%axes(:, 1) = foot%axes(:, 1)/norm2(foot%axes(:, 1))
        foot%axes(:, 2) = across(foot%normal, foot%axes(:, 1))
        form = form_along(patch, foot%at(2:), foot%normal)
        slope = form%first
        diagonal = [along(foot%axes(:, 1)), along(foot%axes(:, 2)), &
            along(foot%axes(:, 1) + foot%axes(:, 2))]
        foot%bend(1, 1) = diagonal(1)
        foot%bend(2, 2) = diagonal(2)
        foot%bend(1, 2) = 0.5_dp*(diagonal(3) - diagonal(1) - diagonal(2))
        foot%bend(2, 1) = foot%bend(1, 2)
    contains
        !> The second derivative of F along a way, over its slope across the skin.
        pure real(dp) function along(way)
            real(dp), intent(in) :: way(3) !! along the skin
            type(taylor_type) :: second
            second = form_along(patch, foot%at(2:), way)
            along = second%second/slope
        end function along
    end subroutine measure_bend

    !> Where a straight way from a point of the outside meets the inside. False where it does not on
    !> any section, or where the thickness reaches a radius of curvature on the way.
    pure subroutine way_inside(body, thickness, way, foot, is_found)
        type(body_type), intent(in) :: body         !! finished, both halves
        real(dp), intent(in) :: thickness           !! t, deck units
        real(dp), intent(in) :: way(3)              !! unit vector inwards
        type(foot_type), intent(inout) :: foot      !! at the beginning of the way; then Q
        logical, intent(out) :: is_found            !! see above
        type(foot_type) :: start, trial
        integer :: i

        start = foot
        trial = start
        call approach(body, thickness, way, start%at, trial, is_found)
        if (is_found) is_found = is_on_section(body, trial)
        do i = 1, size(body%sections)
            if (is_found) exit
            if (i == start%section) cycle
            trial = start
            trial%section = i
            call approach(body, thickness, way, start%at, trial, is_found)
            if (is_found) is_found = is_on_section(body, trial)
        end do
        if (is_found) foot = trial
    end subroutine way_inside

    !> Newton's method on one section, also beyond its edges, the thickness brought up in steps.
    pure subroutine approach(body, thickness, way, from, foot, is_found)
        type(body_type), intent(in) :: body         !! finished, both halves
        real(dp), intent(in) :: thickness           !! t, deck units
        real(dp), intent(in) :: way(3)              !! unit vector inwards
        real(dp), intent(in) :: from(3)             !! where the way begins, deck units
        type(foot_type), intent(inout) :: foot      !! about there; then Q
        logical, intent(out) :: is_found            !! it converged
        integer :: stage

        is_found = .true.
        do stage = 1, stages
            call settle_inside(body, thickness*real(stage, dp)/real(stages, dp), way, from, foot, &
                is_found)
            if (.not. is_found) return
        end do
    end subroutine approach

    !> Newton's method on one section, also beyond its edges, from a foot that is near to Q.
    pure subroutine settle_inside(body, thickness, way, from, foot, is_found)
        type(body_type), intent(in) :: body         !! finished, both halves
        real(dp), intent(in) :: thickness           !! t, deck units
        real(dp), intent(in) :: way(3)              !! unit vector inwards
        real(dp), intent(in) :: from(3)             !! where the way begins, deck units
        type(foot_type), intent(inout) :: foot      !! near to Q; then Q
        logical, intent(out) :: is_found            !! it converged
        type(foot_type) :: next
        real(dp) :: move(3), least
        integer :: i

        least = huge(1.0_dp)
        do i = 1, most_steps
            is_found = thickness*steepest_curvature(foot) < 1.0_dp
            if (.not. is_found) return
            move = step_of(foot, thickness, from, way)
            call foot_at(body, foot%section, foot%at + move, foot%normal, next, is_found)
            if (.not. is_found) return
            foot = next
            if (norm2(move) >= 0.5_dp*least .and. least <= step_noise*thickness) exit
            least = norm2(move)
        end do
        is_found = least <= step_noise*thickness
    end subroutine settle_inside

    !> Newton's step of Q along the skin: Q - t n + (dQ - t W dQ) = from + s way.
    pure function step_of(foot, t, from, way) result(step)
        type(foot_type), intent(in) :: foot     !! Q
        real(dp), intent(in) :: t               !! deck units
        real(dp), intent(in) :: from(3)         !! deck units
        real(dp), intent(in) :: way(3)          !! unit vector, not along the skin
        real(dp) :: step(3), rest(3), s, wanted(2), m(2, 2), inner

        rest = from - (foot%at - t*foot%normal)
        inner = dot_product(way, foot%normal)
        s = -dot_product(rest, foot%normal)/sign(max(abs(inner), tiny(1.0_dp)), inner)
        wanted = matmul(rest + s*way, foot%axes)
        m = -t*foot%bend
        m(1, 1) = m(1, 1) + 1.0_dp
        m(2, 2) = m(2, 2) + 1.0_dp
        step = matmul(foot%axes, solved(m, wanted))
    end function step_of

    !> The solution of two equations.
    pure function solved(m, right) result(x)
        real(dp), intent(in) :: m(2, 2)     !! not singular
        real(dp), intent(in) :: right(2)    !! right sides
        real(dp) :: x(2), determinant
        determinant = m(1, 1)*m(2, 2) - m(1, 2)*m(2, 1)
        x = [m(2, 2)*right(1) - m(1, 2)*right(2), m(1, 1)*right(2) - m(2, 1)*right(1)]/determinant
    end function solved

    !> The greatest principal curvature, 1/deck unit; positive where the skin is convex.
    pure real(dp) function steepest_curvature(foot) result(k)
        type(foot_type), intent(in) :: foot !! of the outside
        associate (b => foot%bend)
            k = 0.5_dp*(b(1, 1) + b(2, 2)) + norm2([0.5_dp*(b(1, 1) - b(2, 2)), b(1, 2)])
        end associate
    end function steepest_curvature

    !> The normal curvature of the inside along a unit vector: W (1 - t W)**-1.
    pure real(dp) function parallel_curvature(foot, t, way) result(k)
        type(foot_type), intent(in) :: foot !! Q
        real(dp), intent(in) :: t           !! deck units, below the least radius of curvature
        real(dp), intent(in) :: way(3)      !! along the skin
        real(dp) :: m(2, 2), along(2)

        m = -t*foot%bend
        m(1, 1) = m(1, 1) + 1.0_dp
        m(2, 2) = m(2, 2) + 1.0_dp
        along = matmul(way, foot%axes)
        k = dot_product(along, matmul(foot%bend, solved(m, along)))
    end function parallel_curvature

    !> True where a point of a section's conic is on its arc: all three shares of the point in the
    !> control triangle have the signs that those of the shoulder point have.
    pure logical function is_on_section(body, foot)
        type(body_type), intent(in) :: body     !! finished
        type(foot_type), intent(in) :: foot     !! on a conic of one of its sections
        type(trace_type) :: trace
        real(dp), dimension(2) :: chord, here, there, top

        trace = trace_at(body%lines, body%sections(foot%section), foot%at(1))
        chord = trace%finish%point - trace%start%point
        here = foot%at(2:) - trace%start%point
        there = foot%at(2:) - trace%finish%point
        top = trace%shoulder - trace%start%point
        is_on_section = &
            ratio(cross(here, trace%start%tangent), cross(chord, trace%start%tangent)) &
            .and. ratio(cross(there, trace%finish%tangent), -cross(chord, trace%finish%tangent)) &
            .and. ratio(cross(here, chord), cross(top, chord))
    contains
        !> True where a quotient is not below zero, but for noise.
        pure logical function ratio(above, below)
            real(dp), intent(in) :: above   !! its numerator
            real(dp), intent(in) :: below   !! its denominator
            ratio = above*sign(1.0_dp, below) >= -edge_noise*max(abs(below), dot_product(chord, &
                chord))
        end function ratio
    end function is_on_section

end module body_offset
