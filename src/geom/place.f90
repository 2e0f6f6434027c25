!> A place on an arc, `alpha : beta`, of which only the ratio counts: 1 : 0 is the start, 0 : 1 the
!> finish, 1 : 1 the shoulder (where the tangent is parallel to the chord). Both ends are equally
!> fine, which a single parameter from 0 to 1 is not, and the numbers are twofold, so that a place
!> found for a given ordinate gives that ordinate back.
module geom_place
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use geom_twofold, only: exact_difference, operator(*), operator(-), twofold, twofold_type
    implicit none (type, external)
    private

    public :: place_type, place_at, is_start, is_finish, is_before, mirrored

    !> A place on an arc; neither share is negative and one is above zero.
    type :: place_type
        type(twofold_type) :: alpha = twofold_type(1.0_dp, 0.0_dp) !! share of the start
        type(twofold_type) :: beta = twofold_type(0.0_dp, 0.0_dp)  !! share of the finish
    end type place_type

    !> The first point of an arc.
    type(place_type), parameter, public :: at_start = place_type()
    !> The shoulder of an arc: the tangent is parallel to the chord.
    type(place_type), parameter, public :: at_shoulder = &
        place_type(twofold_type(1.0_dp, 0.0_dp), twofold_type(1.0_dp, 0.0_dp))
    !> The last point of an arc.
    type(place_type), parameter, public :: at_finish = &
        place_type(twofold_type(0.0_dp, 0.0_dp), twofold_type(1.0_dp, 0.0_dp))

contains

    !> The place of the usual parameter of a rational curve, 0 at the start and 1 at the finish.
    elemental type(place_type) function place_at(t) result(place)
        real(dp), intent(in) :: t !! 0 to 1
        place = place_type(exact_difference(1.0_dp, t), twofold(t))
    end function place_at

    !> True for the first point of the arc.
    elemental logical function is_start(place)
        type(place_type), intent(in) :: place !! any place
        is_start = is_zero(place%beta%high)
    end function is_start

    !> True for the last point of the arc.
    elemental logical function is_finish(place)
        type(place_type), intent(in) :: place !! any place
        is_finish = is_zero(place%alpha%high)
    end function is_finish

    !> True where the first place is passed before the second on the way along the arc.
    elemental logical function is_before(first, second)
        type(place_type), intent(in) :: first  !! any place
        type(place_type), intent(in) :: second !! any place
        type(twofold_type) :: lead
        lead = first%alpha*second%beta - first%beta*second%alpha
        is_before = lead%high > 0.0_dp
    end function is_before

    !> The same place on the arc run through backwards.
    elemental type(place_type) function mirrored(place)
        type(place_type), intent(in) :: place !! any place
        mirrored = place_type(place%beta, place%alpha)
    end function mirrored

end module geom_place
