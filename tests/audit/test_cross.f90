!> Tables held against one another: the paraboloid BL**2 + WL**2 = STA, of which every section is a
!> circle and every butt line and control line a parabola.
program test_cross
    use audit_cross, only: cross_type, table_title
    use audit_deck, only: deck_audit_type
    use support_audit_deck, only: audit_of
    use support_tap, only: tap_type
    implicit none (type, external)

    character(*), parameter :: lines = &
        'AUDIT,TOP,SIDE|1.,1.000,4.,2.000,9.,3.000,16.,4.000,25.,5.000,36.,6.000,49.,7.000|'// &
        'AUDIT,MHB,PLAN|1.,1.000,4.,2.000,9.,3.000,16.,4.000,25.,5.000,36.,6.000,49.,7.000|'
    character(*), parameter :: section = 'AUDIT,BOWL,STATION,25.,TOP,,MHB|EXACT,X1,0.,Y1,5.000,'// &
        'S1,0.|EXACT,X3,5.000,Y3,0.000|1.,4.899,2.,4.583,3.,4.000,4.,3.000|'
    character(*), parameter :: butt = 'AUDIT,BOWL,BUTTOCK,3.|10.,1.000,13.,2.000,18.,3.000,'// &
        '25.,4.000,34.,5.000,45.,6.000,58.,7.000|'
    type(tap_type) :: tap
    type(deck_audit_type) :: found
    type(cross_type), allocatable :: cross(:)
    integer :: n

    call audit_of(lines//section//butt, found)
    if (allocated(cross)) deallocate (cross)
    allocate (cross, source=found%cross)
    n = size(cross)
    call tap%ok(n == 3 .and. all(cross%agrees), 'two ordinates of the section, and the butt line')
    call tap%same(trim(cross(3)%what), 'WL AT STA 25. BL 3.', 'where they meet')
    call tap%same(table_title(found%item(3))//'/'//table_title(found%item(4)), &
        'BOWL STATION 25./BOWL BUTT LINE 3.', 'by name')

    call audit_of(lines//section//'AUDIT,BOWL,BUTTOCK,2.5|10.25,2.000,15.25,3.000,22.25,4.000,'// &
        '25.,4.330,31.25,5.000,42.25,6.000,55.25,7.000|', found)
    if (allocated(cross)) deallocate (cross)
    allocate (cross, source=found%cross)
    call tap%ok(cross(3)%agrees .and. .not. cross(3)%side(1)%is_printed .and. &
        cross(3)%side(2)%is_printed, 'a butt line without a row of the section: by its line')
    call tap%same(trim(cross(3)%side(1)%text), '4.330', 'sqrt(25 - 6.25)')

    call audit_of(lines//section//'AUDIT,BOWL,BUTTOCK,3.|10.,1.000,13.,2.000,18.,3.000,'// &
        '25.,4.080,34.,5.000,45.,6.000,58.,7.000|', found)
    if (allocated(cross)) deallocate (cross)
    allocate (cross, source=found%cross)
    call tap%ok(.not. cross(3)%agrees .and. .not. cross(3)%side(2)%is_sound .and. &
        cross(3)%side(1)%is_sound .and. nint(cross(3)%apart) == -80, &
        'a bad figure of the butt line differs, and is the one that is suspect')

    call audit_of('AUDIT,A,SIDE|1.,1.000,2.,4.000|AUDIT,A,SIDE|1.,1.000,2.,4.500|', found)
    call tap%ok(size(found%cross) == 0, 'tables too small for a line say nothing')
    call tap%finish()

end program test_cross
