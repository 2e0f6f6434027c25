!> The tolerances of LOFT: each has a name, a unit and a reason. They are handed to the procedures
!> that need them, or used there by name; no other module writes a small number of its own.
module base_tolerances
    use base_kinds, only: dp
    implicit none (type, external)
    private

    !> Relative spacing of doubles at 1: the unit in the last place (ulp) of 1.
    real(dp), parameter, public :: ulp = epsilon(1.0_dp)
    !> How far, in ulp of the largest coordinate, decimals that were meant to be in one line or to
    !> meet an extreme may miss it because binary can't hold them.
    real(dp), parameter, public :: decimal_noise = 4.0_dp
    !> Half the last decimal of a punched slope (F8.5): a slope this near to that of a straight
    !> chord is the chord's slope, rounded. Radians.
    real(dp), parameter, public :: slope_resolution = 0.5e-5_dp
    !> How near the weight of a conic arc must be to 1 to call it a parabola, and how near the axes
    !> of an ellipse to each other to call it a circle: round-off only. Relative.
    real(dp), parameter, public :: type_tolerance = 1.0e-12_dp
    !> Relative error asked of lengths, areas and volumes by quadrature.
    real(dp), parameter, public :: quadrature_tolerance = 1.0e-11_dp
    !> What the last terms of a series may be beside its largest; those left out are less.
    real(dp), parameter, public :: series_tolerance = 1.0e-12_dp
    !> Relative error asked of the moments of a segment, so that sums of many stay exact enough.
    real(dp), parameter, public :: segment_tolerance = 1.0e-13_dp
    !> How far arcs of a section may miss each other and still close it: more than any rounding,
    !> less than can be built. Relative to the longest chord of its arcs.
    real(dp), parameter, public :: outline_gap = 1.0e-6_dp
    !> Step of u or t (0 to 1) below which the search for a nearest point ends; the distance, which
    !> is flat there, is good to rounding long before.
    real(dp), parameter, public :: foot_tolerance = 1.0e-13_dp
    !> Relative error asked of the lengths that spread points along an outline: where they stand is
    !> a matter of choice, that they are on the outline is not.
    real(dp), parameter, public :: spacing_tolerance = 1.0e-6_dp
    !> How far the two ways to a point of a cut may differ before this is an error: deck units, or
    !> ulp of the largest coordinate where these are more.
    real(dp), parameter, public :: agreement_tolerance = 1.0e-10_dp, agreement_ulps = 64.0_dp
    !> How far ends of an outline that are one point may miss each other. Relative to the body.
    real(dp), parameter, public :: meeting_tolerance = 1.0e-9_dp
    !> How much of itself the curvature of a line may jump at a joint and still be said to go on:
    !> decimals of cards can't do better, and no curvature comb shows it.
    real(dp), parameter, public :: fair_curvature = 1.0e-3_dp
    !> By how much end tangents of two sections that meet may differ before it is warned of: more
    !> than slopes and angles of four figures do, less than can be seen in the skin. Degrees.
    real(dp), parameter, public :: tangency_tolerance = 1.0e-2_dp
    !> What a STEP file says of how far vertices, edges and faces that meet may be apart, in the
    !> unit of the file. They meet but for rounding, whatever the skin's distance from the exact
    !> one is; readers that are told more look less closely, and move edges by as much.
    real(dp), parameter, public :: step_tolerance = 1.0e-7_dp
    !> How near the area of a faired curve comes to the area asked: relative. What is promised is
    !> 1e-10; a step of Newton's more costs nothing.
    real(dp), parameter, public :: area_tolerance = 1.0e-12_dp
    !> Relative width of the bracket in which the critical multiplier of a faired curve is found,
    !> and how much of it may be used: beyond, the curve is all bulges.
    real(dp), parameter, public :: critical_tolerance = 1.0e-9_dp, critical_share = 0.999_dp
    !> How near the edges of a panel are to its sides: less than can be measured on any part, more
    !> than rounding. Relative to the panel.
    real(dp), parameter, public :: panel_tolerance = 1.0e-9_dp
    !> How near the curves of cuts on panels are to them in drawings. Relative to the panel.
    real(dp), parameter, public :: panel_curve_tolerance = 1.0e-8_dp
    !> A curvature below this part of 1 over the length of a panel is rounding: over the whole panel
    !> it bends by less than an atom.
    real(dp), parameter, public :: straight_curvature = 1.0e-11_dp

end module base_tolerances
