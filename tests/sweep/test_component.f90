!> CHECK cards as components.
program test_component
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use cut_clearance, only: component_kind, component_type
    use deck_job, only: job_type
    use support_job_deck, only: body_text, job_of
    use support_tap, only: tap_type
    use sweep_component, only: component_of
    implicit none (type, external)

    type(tap_type) :: tap
    type(job_type) :: job
    type(fault_list_type) :: faults
    type(component_type) :: component

    call job_of(body_text//'SKIN,.25|CHECK,POINT,1.,2.,3.,.5,DOT|CHECK,SPHERE,1.,2.,3.,4.,.5|'// &
        'CHECK,BOX,1.,2.,3.,4.,5.,6.,.5,CRATE|STATION,1', job, faults)
    component = component_of(job%body(1)%check(1))
    call tap%ok(component%kind == component_kind%point .and. component%name == 'DOT', 'a point')
    call tap%ok(all(abs(component%at - [1.0_dp, 2.0_dp, 3.0_dp]) <= 0.0_dp), 'where it is')
    call tap%near(component%skin, 0.25_dp, 0.0_dp, 'the skin that holds for it')
    call tap%near(component%clearance, 0.5_dp, 0.0_dp, 'the clearance that is asked for')
    component = component_of(job%body(1)%check(2))
    call tap%ok(component%kind == component_kind%sphere, 'a sphere')
    call tap%near(component%radius, 4.0_dp, 0.0_dp, 'its radius')
    call tap%near(component%clearance, 0.5_dp, 0.0_dp, 'its clearance')
    component = component_of(job%body(1)%check(3))
    call tap%ok(component%kind == component_kind%box .and. &
        all(abs(component%other - [4.0_dp, 5.0_dp, 6.0_dp]) <= 0.0_dp), 'a box')
    call tap%finish()
end program test_component
