!> Start and global section: plain words, unit, resolution, dates.
program test_iges_head
    use base_constants, only: version
    use base_error, only: error_type
    use base_kinds, only: dp
    use base_text, only: row_of
    use export_drawing, only: drawing_type
    use export_iges_card, only: section_type
    use export_iges_head, only: put_global, put_start, resolution_of
    use export_units, only: find_unit, unit_type
    use support_iges_deck, only: deck_of, deck_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(drawing_type) :: drawing
    type(unit_type) :: unit
    type(error_type), allocatable :: error

    drawing%deck = 'nose.crd'
    drawing%title = 'NOSE, FIRST; SAE'
    drawing%units = 'MM'
    drawing%tolerance = 0.0254_dp
    call check_start()
    call check_global('INCHES', '1,2HIN', '0.01', '1.D-06')
    call check_global('MM', '2,2HMM', '0.254', '0.000025399999999999997')
    call check_global('FEET', '4,2HFT', '0.0008333333333333333', '8.333333333333333D-08')
    call check_global('M', '6,1HM', '0.000254', '2.54D-08')
    drawing%title = ''
    call check_title()
    call find_unit('INCHES', unit, error)
    call tap%ok(resolution_of(unit, 1.0e-7_dp) == 1.0e-7_dp, 'no coarser than the tolerance')
    call tap%ok(resolution_of(unit, 0.0_dp) == 1.0e-6_dp, 'where there is one')
    call tap%finish()

contains

    !> Plain words, in 72 columns.
    subroutine check_start()
        type(section_type) :: section
        type(deck_type) :: deck

        section = section_type('S')
        call put_start(section, drawing, 'Level 1: STA_0'//new_line('a')//'Level 2: '// &
            row_of('x', 70)//new_line('a'))
        deck = deck_of(section%text())
        call tap%ok(deck%is_even .and. all(deck%cards(:)(73:73) == 'S'), 'cards of section S')
        call tap%same(trim(deck%cards(1)(:72)), 'LOFT '//version// &
            ': curves and skin of nose.crd', 'what it is')
        call tap%same(trim(deck%cards(2)(:72)), 'NOSE, FIRST; SAE', 'the title of the deck')
        call tap%same(trim(deck%cards(3)(:72)), &
            'Lengths in MM; x is STA, aft; y is BL, to starboard; z is WL, up.', 'unit and axes')
        call tap%same(trim(deck%cards(4)(:72)), &
            'Fitted curves and surfaces are within 0.0254 of the exact shape.', 'tolerance')
        call tap%same(trim(deck%cards(5)(:72)), 'Level 1: STA_0', 'the levels')
        call tap%same(deck%cards(6)(:72)//trim(deck%cards(7)(:72)), 'Level 2: '//row_of('x', 70), &
            'long words go on')
        call tap%ok(size(deck%cards) == 7, 'and no more')
    end subroutine check_start

    !> The facts of a file in a unit.
    subroutine check_global(name, flag, width, least)
        character(*), intent(in) :: name    !! of the unit
        character(*), intent(in) :: flag    !! fields 14 and 15
        character(*), intent(in) :: width   !! field 17
        character(*), intent(in) :: least   !! field 19

        call find_unit(name, unit, error)
        call tap%same(global_of(), '1H,,1H;,16HNOSE, FIRST; SAE,8Hnose.crd,10HLOFT '//version// &
            ',10HLOFT '//version//',32,308,15,308,15,16HNOSE, FIRST; SAE,1.,'//flag//',1,'// &
            width//',15H19700101.000000,'//least//',300.5,,,11,0,15H19700101.000000,;', &
            'the 26 facts of a file in '//name)
    end subroutine check_global

    !> A deck without title goes by its name.
    subroutine check_title()
        call tap%ok(index(global_of(), '1H,,1H;,8Hnose.crd,8Hnose.crd,') == 1, &
            'a deck without title goes by its name')
    end subroutine check_title

    !> All of the global section.
    function global_of() result(text)
        character(:), allocatable :: text
        type(section_type) :: section
        type(deck_type) :: deck
        integer :: i

        section = section_type('G')
        call put_global(section, drawing, unit, 300.5_dp, resolution_of(unit, 0.001_dp))
        deck = deck_of(section%text())
        text = ''
        do i = 1, size(deck%cards)
            text = text//trim(deck%cards(i)(:72))
        end do
    end function global_of

end program test_iges_head
