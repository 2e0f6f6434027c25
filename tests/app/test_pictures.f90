!> Which picture a card is in, by its name.
program test_pictures
    use app_pictures, only: conics, picture_of, plan, sections, side
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call tap%ok(picture_of('MHB SIDE') == side, 'SIDE is the side view')
    call tap%ok(picture_of('max half-breadth, plan') == plan, &
        'plan in small letters is the plan view')
    call tap%ok(picture_of('Sta 0 contour') == sections, 'Sta is a section')
    call tap%ok(picture_of('STATION 25.4') == sections, 'STATION is a section')
    call tap%ok(picture_of('section: floor') == sections, 'section with a colon is a section')
    call tap%ok(picture_of('STA.10') == sections, 'a point ends a word')
    call tap%ok(picture_of('(side)') == side, 'brackets bound a word')
    call tap%ok(picture_of('sides') == conics .and. picture_of('inside') == conics, &
        'SIDE in a longer word is not meant')
    call tap%ok(picture_of('PLANE') == conics .and. picture_of('airplan') == conics, &
        'nor is PLAN')
    call tap%ok(picture_of('STA10') == conics .and. picture_of('start') == conics, 'nor is STA')
    call tap%ok(picture_of('sta'//char(195)//char(164)) == conics, &
        'a letter beyond ASCII belongs to the word')
    call tap%ok(picture_of('inside SIDE') == side, 'a later word counts')
    call tap%ok(picture_of('') == conics, 'a card without a name is among the conics')
    call tap%ok(picture_of('S') == conics, 'so is one with a short name')
    call tap%ok(picture_of('STA 10, plan') == plan .and. picture_of('plan and side') == side, &
        'of several words side comes first, then plan')
    call tap%finish()
end program test_pictures
