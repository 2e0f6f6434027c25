!> Tests of bevel marks, on a sphere: its normal is known, and arcs of its circles are as long as
!> their angle says.
program test_drawing_marks
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_outline, only: cut_type
    use cut_plane, only: flange_normal, in_space, plane_type, station_plane, waterline_plane
    use export_drawing, only: shape_type
    use export_drawing_cut, only: draw_cut
    use support_bodies, only: ellipsoid
    use support_cutting, only: by_number, cut_of, plane_of
    use support_tap, only: tap_type
    implicit none (type, external)

    real(dp), parameter :: radius = 20.0_dp, centre(3) = [30.0_dp, 0.0_dp, 0.0_dp], &
        pi = acos(-1.0_dp)
    type(tap_type) :: tap
    type(body_type) :: body
    type(cut_type) :: cut
    type(shape_type) :: shape
    type(error_type), allocatable :: error

    body = ellipsoid([radius, radius, radius], centre(1), 0.0_dp)
    call go(station_plane(18.0_dp), 1.0_dp, .false., 'frame forward of the middle')
    call tap%ok(size(shape%contours(1)%marks) == 51, 'half a circle of radius 16 has 51 marks')
    call go(station_plane(42.0_dp), 1.0_dp, .true., 'frame aft, its flange forward')
    call go(waterline_plane(12.0_dp), 1.0_dp, .false., 'floor')
    call go(plane_of([30.0_dp, 0.0_dp, 12.0_dp], [0.0_dp, 0.8_dp, 0.6_dp]), pi, .false., &
        'canted frame')
    call tap%ok(shape%contours(1)%is_closed, 'which is closed')
    call go(plane_of([30.0_dp, 12.0_dp, 0.0_dp], [0.0_dp, 1.0_dp, 0.0_dp]), pi, .false., &
        'closed circle of radius 16')
    call tap%ok(size(shape%contours(1)%marks) == 32, &
        'a step that goes evenly does not mark where it began again')
    call draw_cut(body, cut, 1.0e-4_dp, 0.0_dp, shape, error)
    call tap%ok(size(shape%contours(1)%marks) == 0, 'no step, no marks')
    call tap%finish()

contains

    !> Draws a cut and judges its marks.
    subroutine go(plane, step, is_forward, name)
        type(plane_type), intent(in) :: plane
        real(dp), intent(in) :: step
        logical, intent(in) :: is_forward
        character(*), intent(in) :: name
        real(dp) :: n(3), f(3), q(3), bevel, across, off, between, ring, middle(2)
        integer :: k

        cut = cut_of(body, by_number(plane, 5))
        cut%is_flange_forward = is_forward
        call draw_cut(body, cut, 1.0e-9_dp, step, shape, error)
        f = flange_normal(cut%plane, is_forward)
        bevel = 0.0_dp
        across = 0.0_dp
        off = 0.0_dp
        between = 0.0_dp
        associate (marks => shape%contours(1)%marks)
            do k = 1, size(marks)
                q = in_space(cut%plane, marks(k)%uv)
                n = (q - centre)/norm2(q - centre)
                off = max(off, abs(norm2(q - centre) - radius))
                bevel = max(bevel, abs(sin(marks(k)%bevel*pi/180.0_dp) + dot_product(n, f)))
                middle = [dot_product(cut%plane%u, n), dot_product(cut%plane%v, n)]
                ring = norm2(middle)
                across = max(across, norm2(marks(k)%outward - middle/ring))
                if (k == 1) cycle
                ring = ring*radius
                between = max(between, abs(2.0_dp*ring*asin(norm2(marks(k)%uv &
                    - marks(k - 1)%uv)/(2.0_dp*ring)) - step))
            end do
        end associate
        call tap%near(off, 0.0_dp, 1.0e-9_dp, name//': marks are on the contour')
        call tap%near(bevel, 0.0_dp, 1.0e-9_dp, name//': bevels')
        call tap%near(across, 0.0_dp, 1.0e-9_dp, name//': unit vectors out of the body')
        call tap%near(between, 0.0_dp, 1.0e-4_dp, name//': a step apart')
    end subroutine go

end program test_drawing_marks
