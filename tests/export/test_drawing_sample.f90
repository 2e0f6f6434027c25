!> Tests of sampled curves.
program test_drawing_sample
    use base_kinds, only: dp
    use export_drawing_sample, only: sample_curve, sampled_type
    use support_paths, only: form, plane_path_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(sampled_type) :: sampled
    type(plane_path_type) :: path

    path = plane_path_type(form=form%ellipse, axes=[30.0_dp, 20.0_dp], ends=[0.0_dp, 1.5_dp])
    call sample_curve(path, 1.0e-12_dp, sampled)
    call tap%ok(size(sampled%panel) == 1, 'a quarter of an ellipse takes one panel')
    call tap%near(miss(), 0.0_dp, 2.0e-13_dp, 'which has all its points')
    call tap%ok(sampled%rest <= 1.0e-12_dp, 'and says so')
    path%ends = [0.0_dp, 60.0_dp]
    call sample_curve(path, 1.0e-10_dp, sampled)
    call tap%ok(size(sampled%panel) > 8 .and. size(sampled%panel) < 40, 'ten turns take more')
    call tap%near(miss(), 0.0_dp, 1.0e-10_dp, 'and keep the tolerance')
    call tap%ok(all(abs(sampled%at(0.0_dp) - path%at(0.0_dp)) <= 0.0_dp) .and. &
        all(abs(sampled%at(1.0_dp) - path%at(1.0_dp)) <= 0.0_dp), 'the ends are those of the curve')
    path = plane_path_type(form=form%cubic, axes=[1.0_dp, 7.0_dp])
    call sample_curve(path, 1.0e-13_dp, sampled)
    call tap%near(miss(), 0.0_dp, 1.0e-14_dp, 'a cubic is had to rounding')
    path = plane_path_type(form=form%step, axes=[1.0_dp, 1.0_dp])
    call sample_curve(path, 1.0e-9_dp, sampled)
    call tap%ok(size(sampled%panel) < 40, 'a jump takes panels down to 1e-9 of the parameter')
    call tap%near(sampled%panel(size(sampled%panel))%from, 0.5_dp, 1.0e-8_dp, &
        'where it is given up')
    call tap%ok(sampled%rest > 0.1_dp, 'what is left is told')
    call tap%finish()

contains

    !> The largest difference between samples and curve.
    real(dp) function miss()
        integer :: i
        miss = 0.0_dp
        do i = 0, 999
            associate (t => real(i, dp)/999.0_dp)
                miss = max(miss, norm2(sampled%at(t) - path%at(t)))
            end associate
        end do
    end function miss

end program test_drawing_sample
