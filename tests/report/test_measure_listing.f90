!> Measures on pages: sections with and without area, volume with its error.
program test_measure_listing
    use base_kinds, only: dp
    use base_output, only: output_type
    use cut_measure_body, only: body_measure_type
    use report_measure_listing, only: print_measures
    use report_ordinate, only: new_form
    use report_page, only: page_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_measure_type) :: measure
    character(:), allocatable :: text

    measure%from = 0.0_dp
    measure%to = 10.0_dp
    allocate (measure%curve(2))
    measure%curve%sta = [0.0_dp, 5.0_dp]
    measure%curve%has_girth = .true.
    measure%curve%girth = [1.0_dp, 2.0_dp]
    measure%curve(1)%why = 'the section is open'
    measure%curve(2)%has_area = .true.
    measure%curve(2)%area = 3.0_dp
    measure%curve(2)%centroid = [0.0_dp, -4.0_dp]
    measure%curve(2)%inertia = [5.0_dp, 6.0_dp, 0.0_dp]
    measure%has_wetted = .true.
    measure%wetted_area = 100.0_dp
    measure%wetted_error = 2.5e-9_dp
    measure%why = 'it is open'
    text = listing('INCHES')
    call tap%has(text, '      0.000      1.000           -', 'a section without area has a dash')
    call tap%has(text, &
        '      5.000      2.000       3.000      -4.000          5.000          6.000', &
        'one with area has area, centroid and moments')
    call tap%has(text, 'WITHOUT AREA: AT STA 0.000 the section is open', 'the reason stands below')
    call tap%has(text, 'WETTED AREA           100.000000   ERROR BELOW 2.5E-09', &
        'the wetted area has the estimate of its error')
    call tap%has(text, 'NO VOLUME: it is open', 'a body that does not close says so')
    call tap%ok(index(text, 'PRODUCT') == 0, 'of a section with two like sides no more is said')
    measure%curve(2)%centroid = [1.5_dp, -4.0_dp]
    measure%curve(2)%inertia(3) = 7.0_dp
    text = listing('INCHES')
    call tap%has(text, 'CENTROID BL       1.500        PRODUCT          7.000', &
        'where the sides differ, the BL of the centroid and the product moment stand below')
    measure%has_volume = .true.
    measure%volume = 1.0_dp
    text = listing('INCHES')
    call tap%has(text, 'VOLUME                  1.000000', 'one that closes has a volume')
    text = listing('MM')
    call tap%has(text, &
        'VOLUME              16387.064000', 'in cubic millimetres, 25.4**3 to a cubic inch')
    call tap%has(text, '50.800', 'girths follow the unit: 2 in are 50.8 mm')
    deallocate (measure%curve)
    allocate (measure%curve(0))
    text = listing('INCHES')
    call tap%same(text, '', 'without sections nothing is measured')
    call tap%finish()

contains

    !> The measures of a deck in inches, printed in a unit.
    function listing(output) result(text)
        character(*), intent(in) :: output !! INCHES or MM
        character(:), allocatable :: text
        type(page_type) :: page
        type(output_type) :: out
        call page%set_heading('TITLE', 'deck.crd', output)
        call print_measures(page, measure, new_form('INCHES', output, 3), out)
        text = out%text()
    end function listing

end program test_measure_listing
