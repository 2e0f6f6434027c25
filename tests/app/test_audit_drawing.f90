!> The picture of an audited table: its axes, band, marks and names of suspects.
program test_audit_drawing
    use app_audit_drawing, only: residual_drawing
    use audit_deck, only: deck_audit_type
    use audit_reading, only: sort
    use base_kinds, only: dp
    use export_body_drawing, only: drawing_type
    use support_audit_deck, only: audit_of, parabola
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(deck_audit_type) :: found
    type(drawing_type) :: drawing

    call audit_of(parabola, found)
    drawing = residual_drawing(found%item(1), sort%ordinate, 'OLD TABLES', 'INCHES')
    call tap%same(drawing%heading//'/'//drawing%view//'/'//drawing%x_axis, &
        'OLD TABLES/PAR SIDE: figures less the line found/X, INCHES', 'what it is of')
    call tap%ok(drawing%low(1) < 5.0_dp .and. drawing%high(1) > 45.0_dp, 'from row to row')
    call tap%ok(strokes('point') == 9 .and. strokes('mirror') == 2 .and. strokes('joint') == 0, &
        'nine sound figures and the band')
    call tap%ok(drawing%count == 1 .and. drawing%words(1)%text == 'no figure is suspect', &
        'which is said')
    drawing = residual_drawing(found%item(1), sort%abscissa, 'OLD TABLES', 'INCHES')
    call tap%ok(drawing%layers == 0, 'there are no rows along Y')

    call audit_of('AUDIT,PAR,SIDE|EXACT,X1,0.,Y1,0.,S1,0.|EXACT,X3,50.,Y3,25.|ABOUT,S3,1.00|'// &
        '5.,.250,10.,1.000,15.,2.280,20.,4.000|25.,6.?50,30.,9.000,35.,12.250|', found)
    drawing = residual_drawing(found%item(1), sort%ordinate, '', 'MM')
    call tap%ok(strokes('joint') == 1 .and. strokes('point') == 5, &
        'a suspect is marked, what can not be read is not drawn')
    call tap%same(drawing%words(1)%text, '2.280 [2.250]', 'by its name')
    call tap%ok(drawing%layer(layer_of('joint'))%stroke(1)%at(2, 1) < drawing%high(2), &
        'inside of the picture, though 30 units off')
    call tap%finish()

contains

    !> The layer of a style, or 0.
    integer function layer_of(style) result(layer)
        character(*), intent(in) :: style !! of its lines
        do layer = drawing%layers, 1, -1
            if (drawing%layer(layer)%style == style) return
        end do
    end function layer_of

    !> Lines of a style.
    integer function strokes(style)
        character(*), intent(in) :: style !! of the lines
        strokes = 0
        if (layer_of(style) > 0) strokes = drawing%layer(layer_of(style))%count
    end function strokes

end program test_audit_drawing
