!> A picture of arcs: what it is called, what its axes are, which curves are on it. A writer of any
!> format draws it; it knows of no deck.
module export_picture
    use base_kinds, only: dp
    use export_polyline, only: polyline
    use geom_arc, only: arc_type
    implicit none (type, external)
    private

    public :: picture_type, curve_type, frame_type, frame_of

    !> One curve: an arc with the three points that fix it.
    type :: curve_type
        character(:), allocatable :: name  !! as the legend gives it, any bytes
        type(arc_type) :: arc              !! the curve
        real(dp) :: point(2, 3) = 0.0_dp   !! points 1, 2 (the shoulder point) and 3, deck units
        real(dp), allocatable :: line(:, :) !! the curve as points close together; `add` sets it
    end type curve_type

    !> A picture.
    type :: picture_type
        character(:), allocatable :: name     !! name of its files, without ending
        character(:), allocatable :: heading  !! what it is of, any bytes
        character(:), allocatable :: view     !! `Side view` and the like
        character(:), allocatable :: x_axis   !! name and unit of the axis to the right
        character(:), allocatable :: y_axis   !! name and unit of the axis upwards
        integer :: count = 0                  !! number of curves
        type(curve_type), allocatable :: curve(:) !! the curves, `curve(1:count)`
    contains
        procedure :: add => add_curve
    end type picture_type

    !> The part of the plane that a picture shows, deck units.
    type :: frame_type
        real(dp) :: low(2) = 0.0_dp  !! left and lower edge
        real(dp) :: high(2) = 0.0_dp !! right and upper edge
        real(dp) :: span = 0.0_dp    !! largest extent of what is drawn; marks are sized by it
    end type frame_type

    !> Room around the curves for tangents and figures, in parts of the span.
    real(dp), parameter :: margin = 0.1_dp
    !> The least share of its other side that a side of the frame may have.
    real(dp), parameter :: slimmest = 0.3_dp

contains

    !> Puts a curve on a picture.
    pure subroutine add_curve(picture, curve)
        class(picture_type), intent(inout) :: picture !! the picture
        type(curve_type), intent(in) :: curve         !! what to add
        type(curve_type), allocatable :: grown(:)

        if (.not. allocated(picture%curve)) allocate (picture%curve(8))
        if (picture%count == size(picture%curve)) then
            allocate (grown(2*picture%count))
            grown(:picture%count) = picture%curve
            call move_alloc(grown, picture%curve)
        end if
        picture%count = picture%count + 1
        picture%curve(picture%count) = curve
        picture%curve(picture%count)%line = polyline(curve%arc)
    end subroutine add_curve

    !> The frame that holds all curves of a picture and their marks, never slimmer than
    !> `slimmest`, so that a level line is a picture too.
    pure type(frame_type) function frame_of(picture) result(frame)
        type(picture_type), intent(in) :: picture !! at least one curve
        real(dp) :: half(2), middle(2)
        integer :: i

        frame%low = picture%curve(1)%point(:, 1)
        frame%high = frame%low
        do i = 1, picture%count
            associate (line => picture%curve(i)%line, point => picture%curve(i)%point)
                frame%low = min(frame%low, minval(line, dim=2), minval(point, dim=2))
                frame%high = max(frame%high, maxval(line, dim=2), maxval(point, dim=2))
            end associate
        end do
        frame%span = maxval(frame%high - frame%low)
        middle = 0.5_dp*frame%low + 0.5_dp*frame%high
        half = 0.5_dp*(frame%high - frame%low) + margin*frame%span
        half = max(half, slimmest*maxval(half))
        frame%low = middle - half
        frame%high = middle + half
    end function frame_of

end module export_picture
