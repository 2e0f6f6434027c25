!> The curvature comb of a view of a control line: teeth square to the line, as long as it is curved
!> there, on the outside of the bend, and a ridge over their ends. A fair line has a ridge without
!> steps or waves.
!>
!> A tooth is `factor` times the curvature: the factor is round, and makes the teeth of most of the
!> line easy to see. Where a line bends much more, as in a blunt nose, teeth are cut off.
module export_body_comb
    use base_error, only: error_type
    use base_kinds, only: dp
    use export_body_drawing, only: drawn_stroke_type => stroke_type
    use geom_chain, only: chain_type
    use geom_place, only: place_type
    use geom_stroke, only: stroke_curvature, stroke_point, stroke_tangent, stroke_type
    use geom_stroke_length, only: stroke_length, stroke_places
    implicit none (type, external)
    private

    public :: comb_type, new_comb

    !> Curvature along an arc.
    type :: sample_type
        real(dp), allocatable :: at(:, :)       !! points by columns, deck units
        real(dp), allocatable :: outwards(:, :) !! left of the line, unit vectors by columns
        real(dp), allocatable :: curvature(:)   !! 1/deck unit
    end type sample_type

    !> A comb.
    type :: comb_type
        type(drawn_stroke_type), allocatable :: tooth(:)  !! each from the line outwards
        type(drawn_stroke_type), allocatable :: ridge(:)  !! one an arc
        real(dp) :: factor = 0.0_dp                 !! tooth over curvature; 0: straight
        real(dp) :: greatest = 0.0_dp               !! curvature of largest magnitude, 1/deck unit
        real(dp) :: greatest_at = 0.0_dp            !! its station, deck units
        logical :: is_cut_off = .false.             !! some teeth are
    end type comb_type

    !> Points of the ridge for each tooth, and the least number on an arc.
    integer, parameter :: points_a_tooth = 4, least_points = 33
    !> A tooth of the median curvature has this part of the full length, at least; a tooth is cut
    !> off at this many full lengths.
    real(dp), parameter :: median_part = 0.3_dp, cut_off = 1.15_dp
    !> Curvature below which a line is straight: parts of 1/length.
    real(dp), parameter :: straight = 1.0e-9_dp

contains

    !> The comb of a view. Where lengths along an arc can't be worked the arc has no teeth.
    pure type(comb_type) function new_comb(chain, reach, spacing) result(comb)
        type(chain_type), intent(in) :: chain   !! not a constant
        real(dp), intent(in) :: reach           !! length of a full tooth, deck units
        real(dp), intent(in) :: spacing         !! from tooth to tooth, deck units
        type(sample_type) :: samples(size(chain%stroke))
        real(dp), allocatable :: values(:)
        integer :: i, k

        allocate (comb%tooth(0), comb%ridge(0), values(0))
        do i = 1, size(samples)
            call take_sample(chain%stroke(i), spacing, samples(i))
            values = [values, abs(samples(i)%curvature)]
            if (size(samples(i)%curvature) == 0) cycle
            k = maxloc(abs(samples(i)%curvature), dim=1)
            if (abs(samples(i)%curvature(k)) <= abs(comb%greatest)) cycle
            comb%greatest = samples(i)%curvature(k)
            comb%greatest_at = samples(i)%at(1, k)
        end do
        if (abs(comb%greatest)*(chain%knot(size(chain%knot)) - chain%knot(1)) < straight) return
        comb%factor = round_factor(reach/min(abs(comb%greatest), &
            median(pack(values, values > straight*abs(comb%greatest)))/median_part))
        comb%is_cut_off = comb%factor*abs(comb%greatest) > cut_off*reach
        do i = 1, size(samples)
            call add_teeth(samples(i), cut_off*reach, comb)
        end do
    end function new_comb

    !> The greatest factor of 1, 2 or 5 and zeros that is not above another.
    pure real(dp) function round_factor(factor)
        real(dp), intent(in) :: factor !! above zero
        real(dp) :: power
        power = 10.0_dp**floor(log10(factor))
        round_factor = power
        if (factor >= 2.0_dp*power) round_factor = 2.0_dp*power
        if (factor >= 5.0_dp*power) round_factor = 5.0_dp*power
    end function round_factor

    !> Curvature at equal lengths along a stroke.
    pure subroutine take_sample(stroke, spacing, sample)
        type(stroke_type), intent(in) :: stroke     !! towards greater x
        real(dp), intent(in) :: spacing             !! from tooth to tooth, deck units
        type(sample_type), intent(out) :: sample    !! empty where lengths can't be worked
        type(place_type), allocatable :: places(:)
        type(error_type), allocatable :: error
        real(dp) :: length, ahead(2)
        integer :: i, count

        call stroke_length(stroke, length, error)
        if (.not. allocated(error)) then
            count = max(least_points, points_a_tooth*ceiling(length/spacing) + 1)
            call stroke_places(stroke, count, places, error)
        end if
        if (allocated(error)) allocate (sample%at(2, 0), sample%outwards(2, 0), sample%curvature(0))
        if (allocated(error)) return
        allocate (sample%at(2, count), sample%outwards(2, count), sample%curvature(count))
        do i = 1, count
            sample%at(:, i) = stroke_point(stroke, places(i))
            ahead = stroke_tangent(stroke, places(i))
            sample%outwards(:, i) = [-ahead(2), ahead(1)]/norm2(ahead)
            sample%curvature(i) = stroke_curvature(stroke, places(i))
        end do
    end subroutine take_sample

    !> Puts the teeth and the ridge of an arc to a comb, on the right of a line that turns left.
    pure subroutine add_teeth(sample, longest, comb)
        type(sample_type), intent(in) :: sample !! along an arc
        real(dp), intent(in) :: longest         !! tooth, deck units
        type(comb_type), intent(inout) :: comb  !! with its factor
        type(drawn_stroke_type) :: ridge, across
        real(dp) :: tooth
        integer :: i

        allocate (across%at(2, 2))
        if (size(sample%curvature) == 0) return
        allocate (ridge%at, source=sample%at)
        do i = 1, size(sample%curvature)
            tooth = -max(-longest, min(longest, comb%factor*sample%curvature(i)))
            ridge%at(:, i) = sample%at(:, i) + tooth*sample%outwards(:, i)
            if (modulo(i, points_a_tooth) /= 1 .and. i /= size(sample%curvature)) cycle
            across%at = reshape([sample%at(:, i), ridge%at(:, i)], [2, 2])
            comb%tooth = [comb%tooth, across]
        end do
        comb%ridge = [comb%ridge, ridge]
    end subroutine add_teeth

    !> The value that half the others exceed.
    pure real(dp) function median(values)
        real(dp), intent(in) :: values(:) !! at least one
        real(dp) :: low, high, middle
        integer :: i
        integer, parameter :: halvings = 40

        low = minval(values)
        high = maxval(values)
        do i = 1, halvings
            middle = 0.5_dp*(low + high)
            if (2*count(values > middle) > size(values)) then
                low = middle
            else
                high = middle
            end if
        end do
        median = 0.5_dp*(low + high)
    end function median

end module export_body_comb
