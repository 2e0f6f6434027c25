!> Faired outlines as cuts: a circle, where length, slope and curvature are known, and the inlet.
program test_faired
    use base_constants, only: pi
    use base_error, only: error_type
    use base_kinds, only: dp
    use body_outline, only: outline_type
    use cut_faired, only: faired_cut, measured_cut, ring_length
    use cut_outline, only: cut_type
    use geom_fairing, only: fair
    use geom_fairing_system, only: fairing_end
    use support_inlet, only: inlet
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_circle(tap)
    call check_inlet(tap)
    call tap%finish()

contains

    !> Forty points of a circle of radius 10: the spline through them is one within 1e-5.
    subroutine check_circle(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(outline_type) :: outline
        type(cut_type) :: cut
        type(error_type), allocatable :: error
        real(dp) :: angle, length, worst
        integer :: i

        outline%name = 'RING'
        outline%sta = 3.0_dp
        allocate (outline%measured%point(2, 40), outline%measured%weight(40))
        outline%measured%weight = 1.0e8_dp
        outline%measured%ends = fairing_end%closed
        do i = 1, 40
            angle = 2.0_dp*pi*real(i - 1, dp)/40.0_dp
            outline%measured%point(:, i) = 10.0_dp*[cos(angle), sin(angle)]
        end do
        call fair(outline%measured, 0.0_dp, outline%fairing, error)
        call ring_length(outline%fairing%vertex, length, error)
        call tap%near(length, 20.0_dp*pi, 1.0e-4_dp, 'length of a circle')
        call faired_cut(outline, 12, cut, error)
        call tap%ok(.not. allocated(error) .and. size(cut%outlines) == 1 .and. &
            cut%outlines(1)%is_closed .and. cut%name == 'RING', 'one closed outline')
        worst = 0.0_dp
        do i = 1, 12
            angle = 2.0_dp*pi*real(i - 1, dp)/12.0_dp
            worst = max(worst, norm2(cut%outlines(1)%points(i)%at - [3.0_dp, &
                10.0_dp*cos(angle), 10.0_dp*sin(angle)]))
        end do
        call tap%near(worst, 0.0_dp, 1.0e-4_dp, 'points at equal length')
        associate (points => cut%outlines(1)%points)
            call tap%near(maxval(abs(points%curvature - 0.1_dp)), 0.0_dp, 1.0e-3_dp, 'curvature')
            call tap%near(points(2)%slope%value, -sqrt(3.0_dp), 1.0e-4_dp, 'slope')
            call tap%ok(all(points%section == 1 .and. points%has_slope .and. points%has_curvature &
                .and. .not. points%has_normal), 'slopes and curvatures, no bevels')
        end associate
    end subroutine check_circle

    !> Points of the inlet are at equal length, measured along many more.
    subroutine check_inlet(tap)
        type(tap_type), intent(inout) :: tap !! the tally
        type(outline_type) :: outline
        type(cut_type) :: cut, close
        type(error_type), allocatable :: error
        real(dp) :: length, stretch(7)
        integer :: i, k, after

        outline%measured%point = inlet(:, :14)
        allocate (outline%measured%weight(14), source=100.0_dp)
        outline%measured%ends = fairing_end%closed
        call fair(outline%measured, 0.0_dp, outline%fairing, error)
        call faired_cut(outline, 7, cut, error)
        call faired_cut(outline, 7000, close, error)
        stretch = 0.0_dp
        do i = 1, 7000
            after = 1 + modulo(i, 7000)
            k = 1 + int(real(i - 1, dp)/1000.0_dp)
            stretch(k) = stretch(k) + norm2(close%outlines(1)%points(after)%at &
                - close%outlines(1)%points(i)%at)
        end do
        call ring_length(outline%fairing%vertex, length, error)
        call tap%near(maxval(abs(stretch - length/7.0_dp)), 0.0_dp, 1.0e-6_dp, &
            'stretches of equal length')
        call tap%near(norm2(close%outlines(1)%points(3001)%at - cut%outlines(1)%points(4)%at), &
            0.0_dp, 1.0e-12_dp, 'few points are among many')
        cut = measured_cut(outline)
        call tap%ok(size(cut%outlines(1)%points) == 14 .and. &
            all(cut%outlines(1)%points(2)%uv == inlet(:, 2)), 'the measured points as a cut')
    end subroutine check_inlet

end program test_faired
