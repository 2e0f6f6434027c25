!> Arcs as splines against the points of the arcs, and circles against the circle.
program test_arc_spline
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use geom_arc, only: arc_through, arc_type, end_type, line_between
    use geom_arc_point, only: point
    use geom_arc_spline, only: arc_spline, line_spline
    use geom_bspline, only: bspline_type, spline_point
    use geom_place, only: at_finish, at_start, place_at, place_type
    use geom_subarc, only: place_between, place_of_part
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    !> Weights from nearly a whole ellipse to nearly a corner, and the pieces they take.
    real(dp), parameter :: weights(13) = [-1.0_dp + 1.0e-9_dp, -0.999_dp, -0.5_dp, 0.0_dp, &
        1.0e-9_dp, &
        0.1999_dp, 0.2001_dp, 0.5_dp, 1.0_dp, 3.0_dp, 19.9_dp, 21.0_dp, 1.0e6_dp]
    integer, parameter :: pieces(13) = [4, 4, 2, 2, 2, 2, 1, 1, 1, 1, 1, 2, 4]
    type(bspline_type) :: s
    integer :: i

    do i = 1, size(weights)
        call check_weight(weights(i), pieces(i))
    end do
    call check_circle()
    s = arc_spline(line_between([1.0_dp, 2.0_dp], [5.0_dp, -1.0_dp]))
    call tap%ok(s%degree == 1 .and. all(s%knot == [0.0_dp, 0.0_dp, 1.0_dp, 1.0_dp]) .and. &
        all(s%weight == 1.0_dp), 'a line is of degree 1')
    call tap%ok(all(spline_point(s, 0.25_dp) == [2.0_dp, 1.25_dp]), 'and even along itself')
    s = line_spline([1.0_dp, 2.0_dp, 3.0_dp], [2.0_dp, 4.0_dp, 3.0_dp])
    call tap%ok(all(spline_point(s, 0.5_dp) == [1.5_dp, 3.0_dp, 3.0_dp]), 'a line in space')
    call tap%finish()

contains

    !> An arc of some weight, far from the origin and askew.
    type(arc_type) function arc_of_weight(w) result(arc)
        real(dp), intent(in) :: w !! any weight above -1
        type(error_type), allocatable :: error
        real(dp), parameter :: p(2) = [130.1_dp, -7.3_dp], q(2) = [171.7_dp, 12.9_dp]
        real(dp), parameter :: apex(2) = [140.3_dp, 31.7_dp]
        real(dp) :: ahead(2), back(2), rise(2)

        ! Where w is zero the tangents are parallel to the median; else the corner is off by its
        ! height over w, so that the shoulder stays where it is.
        rise = apex - 0.5_dp*(p + q)
        ahead = w*0.5_dp*(q - p) + (1.0_dp + w)*rise
        back = w*0.5_dp*(q - p) - (1.0_dp + w)*rise
        call arc_through(end_type(p, ahead), apex, end_type(q, back), arc, error)
        call tap%ok(.not. allocated(error), 'there is an arc')
    end function arc_of_weight

    !> The spline of an arc of some weight.
    subroutine check_weight(w, pieces)
        real(dp), intent(in) :: w       !! any weight above -1
        integer, intent(in) :: pieces   !! how many it is parted into
        type(arc_type) :: arc
        type(bspline_type) :: s
        type(place_type), allocatable :: places(:), finer(:)
        real(dp) :: miss, tau, at(2)
        character(12) :: name
        integer :: i, j

        write (name, '(es12.4)') w
        arc = arc_of_weight(w)
        s = arc_spline(arc)
        call tap%ok(size(s%weight) == 2*pieces + 1 .and. s%degree == 2, name//': its pieces')
        call tap%ok(all(s%weight > 0.2_dp) .and. all(s%weight < 20.0_dp), name//': mild weights')
        call tap%ok(all(s%pole(:, 1) == arc%start) .and. all(spline_point(s, &
            1.0_dp) == arc%finish), &
            name//': its ends are as given')
        allocate (places(2))
        places = [at_start, at_finish]
        do while (size(places) <= pieces)
            allocate (finer(2*size(places) - 1))
            finer(1::2) = places
            finer(2::2) = [(place_between(arc, places(i), places(i + 1)), i=1, size(places) - 1)]
            call move_alloc(finer, places)
        end do
        miss = 0.0_dp
        do i = 1, pieces
            do j = 0, 256
                tau = real(j, dp)/256.0_dp
                at = point(arc, place_of_part(arc, places(i), places(i + 1), place_at(tau)))
                miss = max(miss, maxval(abs(at - spline_point(s, (real(i - 1, dp) + tau)/ &
                    real(pieces, dp)))))
            end do
        end do
        call tap%near(miss/spacing(maxval(abs(s%pole))), 0.0_dp, 1.0_dp, &
            name//': points of the arc, in ulp of the largest pole')
        call tap%ok(smooth(s), name//': its pieces meet with one derivative')
    end subroutine check_weight

    !> True where the poles beside each inner joint are in line with it and as far from it.
    logical function smooth(s)
        type(bspline_type), intent(in) :: s !! in pieces of three poles
        integer :: i
        smooth = .true.
        do i = 3, size(s%weight) - 2, 2
            smooth = smooth .and. all(abs(s%pole(:, i - 1) - 2.0_dp*s%pole(:, i) + s%pole(:, i + &
                1)) &
                <= 4.0_dp*spacing(maxval(abs(s%pole)))) .and. abs(s%weight(i - 1) - s%weight(i + &
                1)) <= 8.0_dp*ulp
        end do
    end function smooth

    !> Nearly a whole circle of radius 5 about (1000, -2): within an ulp of 1000.
    subroutine check_circle()
        type(arc_type) :: arc
        type(bspline_type) :: s
        type(error_type), allocatable :: error
        real(dp) :: miss, at(2)
        integer :: i

        call arc_through(end_type([1003.0_dp, 2.0_dp], [-4.0_dp, 3.0_dp]), [1000.0_dp, -7.0_dp], &
            end_type([997.0_dp, 2.0_dp], [4.0_dp, 3.0_dp]), arc, error)
        call tap%ok(.not. allocated(error), 'most of a circle')
        s = arc_spline(arc)
        miss = 0.0_dp
        do i = 0, 1000
            at = spline_point(s, real(i, dp)/1000.0_dp) - [1000.0_dp, -2.0_dp]
            miss = max(miss, abs(norm2(at) - 5.0_dp))
        end do
        call tap%near(miss/(512.0_dp*ulp), 0.0_dp, 1.0_dp, 'is a circle, in ulp of 1000')
    end subroutine check_circle

end program test_arc_spline
