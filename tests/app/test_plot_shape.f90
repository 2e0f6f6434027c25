!> Shapes for pictures: panels with their images, planes that are one.
program test_plot_shape
    use api_computed_body, only: computed_body_type, cut_body
    use app_plot_shape, only: add_images, is_same, shape_of
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_panel, only: panel_type
    use cut_outline, only: cut_type
    use cut_plane, only: buttock_plane, station_plane
    use cut_request, only: request_type
    use deck_job, only: job_type
    use support_job_deck, only: job_of
    use support_pipe, only: pipe_cards
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults
    type(computed_body_type) :: computed
    type(panel_type), allocatable :: panels(:)
    type(request_type) :: request
    type(cut_type) :: shape

    call job_of(pipe_cards//'STATION,15|PATCH,P,10,UCL,20,SHO', job, faults)
    call cut_body(job, 1, computed, faults)
    allocate (panels(0))
    call add_images(computed, panels)
    call tap%ok(size(panels) == 2, 'a panel and its image')
    call tap%ok(panels(1)%outward*panels(2)%outward < 0.0_dp, 'which is turned')
    request%plane = station_plane(15.0_dp)
    shape = shape_of(computed, request, computed%cuts(1))
    call tap%ok(size(shape%outlines) == 1 .and. size(shape%patched) == 1, 'a shape has both')
    if (size(shape%patched) == 1) call tap%ok(size(shape%patched(1)%points) >= 5, 'closely')
    call tap%ok(is_same(station_plane(4.0_dp), station_plane(4.0_dp)), 'one plane')
    call tap%ok(.not. is_same(station_plane(4.0_dp), buttock_plane(4.0_dp)), 'two planes')
    call tap%ok(points_at(0.0_dp) == points_at(5000.0_dp) .and. points_at(0.0_dp) > 12, &
        'a duct has as many points wherever its stations begin')
    call tap%finish()

contains

    !> Points of the shape of a duct that begins at a station.
    integer function points_at(sta) result(count)
        real(dp), intent(in) :: sta !! deck units
        character(*), parameter :: ring = '|5.,0.|0.,5.|-5.,0.|0.,-5.|'
        type(job_type) :: job
        type(fault_list_type) :: faults
        type(computed_body_type) :: computed
        type(request_type) :: request
        type(cut_type) :: shape
        character(8) :: first, last

        write (first, '(f8.1)') sta
        write (last, '(f8.1)') sta + 10.0_dp
        call job_of('FAIRED,A,'//first//ring//'FAIRED,B,'//last//ring//'DUCT,D,A,B', job, faults)
        call cut_body(job, 1, computed, faults)
        request%plane = station_plane(sta + 5.0_dp)
        shape = shape_of(computed, request, shape)
        count = 0
        if (allocated(shape%patched)) count = size(shape%patched(1)%points)
    end function points_at

end program test_plot_shape
