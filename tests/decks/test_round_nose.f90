!> The deck `cards/round-nose.crd` against its closed form: a sphere of radius 15 about (25, 0, 10)
!> forward of station 16, a cone of sine .6 from (0, 0, 10) aft of it.
program test_round_nose
    use api_computed_body, only: computed_body_type
    use base_kinds, only: dp
    use cut_outline, only: cut_point_type
    use support_computed, only: computed_deck
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: pi = acos(-1.0_dp), good = 1.0e-10_dp
    type(tap_type) :: tap
    type(computed_body_type) :: it

    call computed_deck(tap, 'round-nose', it)
    call tap%ok(it%body%has_nose .and. it%body%nose_radius == 15.0_dp, 'the nose is rounded')
    call tap%ok(all(it%body%sections%from == 10.0_dp), 'sections begin at the new nose')
    call prove_cuts()
    call prove_body()
    call prove_ledger()
    call tap%near(it%clearances(1)%gap, 10.0_dp, good, 'clearance from the sphere')
    call tap%near(norm2(it%clearances(1)%nearest - [13.0_dp, 0.0_dp, 19.0_dp]), 0.0_dp, good, &
        'and where it is')
    call tap%near(it%clearances(2)%gap, 2.4_dp, good, 'clearance of a ball from the cone')
    call tap%near(norm2(it%clearances(2)%nearest - [19.36_dp, 0.0_dp, 24.52_dp]), 0.0_dp, good, &
        'and where that is')
    call tap%finish()

contains

    !> Every point and normal of every cut.
    subroutine prove_cuts()
        integer :: i, j, k, fore, aft
        real(dp) :: worst(2)

        worst = 0.0_dp
        fore = 0
        aft = 0
        do i = 1, size(it%cuts)
            call tap%ok(size(it%cuts(i)%outlines) == 1, 'a cut in one outline')
            do j = 1, size(it%cuts(i)%outlines)
                associate (points => it%cuts(i)%outlines(j)%points)
                    do k = 1, size(points)
                        worst = max(worst, miss(points(k)))
                    end do
                    fore = fore + count(points%at(1) < 16.0_dp)
                    aft = aft + count(points%at(1) > 16.0_dp)
                end associate
            end do
        end do
        call tap%ok(fore > 60 .and. aft > 100, 'cuts have points on sphere and cone')
        call tap%near(worst(1), 0.0_dp, good, 'all points are on them')
        call tap%near(worst(2), 0.0_dp, good, 'all normals are theirs')
    end subroutine prove_cuts

    !> How far a point is from sphere or cone, and its normal from theirs.
    function miss(point)
        type(cut_point_type), intent(in) :: point
        real(dp) :: miss(2), out(3), radius

        radius = hypot(point%at(2), point%at(3) - 10.0_dp)
        if (point%at(1) <= 16.0_dp) then
            out = (point%at - [25.0_dp, 0.0_dp, 10.0_dp])/15.0_dp
            miss(1) = abs(norm2(out) - 1.0_dp)*15.0_dp
        else
            out = [-0.6_dp, 0.8_dp*[point%at(2), point%at(3) - 10.0_dp]/radius]
            miss(1) = abs(0.8_dp*radius - 0.6_dp*point%at(1))
        end if
        miss(2) = norm2(point%normal - out)
        if (.not. point%has_normal) miss(2) = 1.0_dp
    end function miss

    !> Volume, wetted area and centroid: a spherical cap 6 high, radii 12 and 60 of the frustum.
    subroutine prove_body()
        associate (measure => it%measure)
            call tap%ok(measure%has_volume .and. measure%has_wetted, 'the body has measures')
            call tap%near(measure%volume/(95700.0_dp*pi), 1.0_dp, good, 'its volume')
            call tap%near(measure%wetted_area/(5940.0_dp*pi), 1.0_dp, good, 'its skin')
            call tap%near(measure%centroid(1), 5757300.0_dp/95700.0_dp, good, 'its centroid')
        end associate
    end subroutine prove_body

    !> Each own view of a line joins its cap at station 16.
    subroutine prove_ledger()
        call tap%ok(size(it%joints) == 7, 'all views but the constant have a joint')
        call tap%ok(all(it%joints%sta == 16.0_dp), 'where sphere and cone meet')
        call tap%near(maxval(abs(it%joints%jump%direction)), 0.0_dp, good, 'slopes go on')
        call tap%near(maxval(it%joints%jump%gap), 0.0_dp, good, 'and meet')
        call tap%near(it%joints(1)%curvature(1), -1.0_dp/15.0_dp, good, &
            'the profile is a circle before it')
    end subroutine prove_ledger

end program test_round_nose
