!> What is asked of a cut: the plane, its limits, how its points are spread, flange and skin.
module cut_request
    use base_decimal, only: grid_type
    use base_kinds, only: dp
    use cut_plane, only: plane_type
    implicit none (type, external)
    private

    public :: request_type, limit_type

    !> How the points of a cut are spread, numbered as on the cards.
    type, public :: rule_list
        integer :: step = 1     !! at stepped ordinates of an axis, and at the ends of every piece
        integer :: number = 2   !! so many on each piece, at equal lengths, ends included
        integer :: length = 3   !! at equal lengths, as near to `step` as goes evenly
        integer :: chord = 4    !! chords stay within `step` of the curve
    end type rule_list

    !> The rules by name: `case (cut_rule%step)`.
    type(rule_list), parameter, public :: cut_rule = rule_list()

    !> What is worked out for each point of a cut, each with what stands before it.
    type, public :: fact_list
        integer :: slope = 1    !! place and slope
        integer :: bevel = 2    !! normal of the skin and bevel
        integer :: all = 3      !! curvature, and the proof of the point by a second way
    end type fact_list

    !> The facts by name: `case (cut_fact%bevel)`.
    type(fact_list), parameter, public :: cut_fact = fact_list()

    !> A range along an axis.
    type :: limit_type
        logical :: has_from = .false.   !! it begins somewhere
        logical :: has_to = .false.     !! it ends somewhere
        real(dp) :: from = 0.0_dp       !! deck units, not above `to`
        real(dp) :: to = 0.0_dp         !! deck units
    end type limit_type

    !> One cut asked for.
    type :: request_type
        type(plane_type) :: plane               !! where to cut
        character(8) :: name = ''               !! or blank
        type(limit_type) :: limit(3)            !! along STA, BL, WL
        integer :: rule = 2                     !! one of `cut_rule%...`
        integer :: axis = 1                     !! `cut_rule%step`: 1 STA, 2 BL, 3 WL
        type(grid_type) :: grid                 !! `cut_rule%step`: the ordinates
        integer :: number = 25                  !! `cut_rule%number`: points on each piece
        real(dp) :: step = 0.0_dp               !! length or tolerance, deck units
        logical :: is_flange_forward = .false.  !! FLANGE FWD
        real(dp) :: skin = 0.0_dp               !! thickness, deck units; 0: not asked
        real(dp) :: arcs = 0.0_dp               !! tolerance of circular arcs; 0: not asked
        integer :: facts = 3                    !! one of `cut_fact%...`: less is faster
    end type request_type

end module cut_request
