!> Fields of the cards of a body deck that say what is wanted of the body: cuts, how their points
!> are spread, clearances.
module deck_body_cut_fields
    use deck_body_layout, only: body_field_type, card => body_card, form, need
    implicit none (type, external)
    private

    !> The cuts and what holds for those that follow.
    type(body_field_type), parameter, public :: cut_fields(40) = [ &
        body_field_type(card%points, 2, 'RULE', form%word, need%always, 'none', &
        'step of an axis, or as said of VALUE', 'STA BL WL NUMBER LENGTH CHORD DEFAULT'), &
        body_field_type(card%points, 3, 'VALUE', form%number, need%optional, 'deck unit', &
        'step; points on each arc; equal arc lengths; chord tolerance'), &
        body_field_type(card%limit, 2, 'AXIS', form%word, need%always, 'none', &
        'the axis; NONE lifts all limits', 'STA BL WL NONE'), &
        body_field_type(card%limit, 3, 'FROM', form%number, need%optional, 'deck unit', &
        'first ordinate; blank: not limited there'), &
        body_field_type(card%limit, 4, 'TO', form%number, need%optional, 'deck unit', &
        'last ordinate; blank: not limited there'), &
        body_field_type(card%flange, 2, 'SIDE', form%word, need%always, 'none', &
        'AFT until a card says FWD', 'AFT FWD'), &
        body_field_type(card%skin, 2, 'T', form%number, need%always, 'deck unit', &
        'thickness; 0. from the start'), &
        body_field_type(card%arcs, 2, 'T', form%number, need%always, 'deck unit', &
        'how far they may be from the curves; 0. ends them'), &
        body_field_type(card%station, 2, 'FROM', form%number, need%always, 'deck unit', &
        'the station, or the first one'), &
        body_field_type(card%station, 3, 'TO', form%number, need%optional, 'deck unit', &
        'last station; blank: one station'), &
        body_field_type(card%station, 4, 'STEP', form%number, need%optional, 'deck unit', &
        'step of the stations; blank: one station'), &
        body_field_type(card%station, 5, 'NAME', form%name, need%optional, 'none', &
        'name of the cut'), &
        body_field_type(card%stations, 2, 'LIST', form%word, need%always, 'none', &
        '', 'LIST'), &
        body_field_type(card%stations, 3, 'STA', form%number, need%repeated, 'deck unit', &
        'the stations, in this field and all that follow'), &
        body_field_type(card%buttock, 2, 'BL', form%number, need%always, 'deck unit', &
        'butt line'), &
        body_field_type(card%buttock, 3, 'FROM', form%number, need%optional, 'deck unit', &
        'first station'), &
        body_field_type(card%buttock, 4, 'TO', form%number, need%optional, 'deck unit', &
        'last station'), &
        body_field_type(card%buttock, 5, 'STEP', form%number, need%optional, 'deck unit', &
        'step of the points along STA; blank: as POINTS says'), &
        body_field_type(card%buttock, 6, 'NAME', form%name, need%optional, 'none', &
        'name of the cut'), &
        body_field_type(card%waterline, 2, 'WL', form%number, need%always, 'deck unit', &
        'waterline'), &
        body_field_type(card%waterline, 3, 'FROM', form%number, need%optional, 'deck unit', &
        'first station'), &
        body_field_type(card%waterline, 4, 'TO', form%number, need%optional, 'deck unit', &
        'last station'), &
        body_field_type(card%waterline, 5, 'STEP', form%number, need%optional, 'deck unit', &
        'step of the points along STA; blank: as POINTS says'), &
        body_field_type(card%waterline, 6, 'NAME', form%name, need%optional, 'none', &
        'name of the cut'), &
        body_field_type(card%oblique, 2, 'STA1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%oblique, 3, 'WL1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%oblique, 4, 'STA2', form%number, need%always, 'deck unit', &
        'second point'), &
        body_field_type(card%oblique, 5, 'WL2', form%number, need%always, 'deck unit', &
        'second point'), &
        body_field_type(card%oblique, 6, 'STEP', form%number, need%optional, 'deck unit', &
        'step of the points along STA; blank: as POINTS says'), &
        body_field_type(card%oblique, 7, 'NAME', form%name, need%optional, 'none', &
        'name of the cut'), &
        body_field_type(card%plane, 2, 'X', form%number, need%always, 'deck unit', &
        'STA of a point of the plane'), &
        body_field_type(card%plane, 3, 'Y', form%number, need%always, 'deck unit', &
        'BL of it'), &
        body_field_type(card%plane, 4, 'Z', form%number, need%always, 'deck unit', &
        'WL of it'), &
        body_field_type(card%plane, 5, 'NX', form%number, need%always, 'none', &
        'normal of the plane, of any length, along STA'), &
        body_field_type(card%plane, 6, 'NY', form%number, need%always, 'none', &
        'along BL'), &
        body_field_type(card%plane, 7, 'NZ', form%number, need%always, 'none', &
        'along WL'), &
        body_field_type(card%plane, 8, 'FROM', form%number, need%optional, 'deck unit', &
        'first station'), &
        body_field_type(card%plane, 9, 'TO', form%number, need%optional, 'deck unit', &
        'last station'), &
        body_field_type(card%plane, 10, 'STEP', form%number, need%optional, 'deck unit', &
        'step of the points along STA; blank: as POINTS says'), &
        body_field_type(card%plane, 11, 'NAME', form%name, need%optional, 'none', &
        'name of the cut')]

    !> The components that must keep clear of the skin.
    type(body_field_type), parameter, public :: check_fields(22) = [ &
        body_field_type(card%check_point, 2, 'KIND', form%word, need%always, 'none', &
        '', 'POINT'), &
        body_field_type(card%check_point, 3, 'STA', form%number, need%always, 'deck unit', &
        'station'), &
        body_field_type(card%check_point, 4, 'BL', form%number, need%always, 'deck unit', &
        'butt line'), &
        body_field_type(card%check_point, 5, 'WL', form%number, need%always, 'deck unit', &
        'waterline'), &
        body_field_type(card%check_point, 6, 'CLEAR', form%number, need%always, 'deck unit', &
        'clearance asked, not negative'), &
        body_field_type(card%check_point, 7, 'NAME', form%name, need%optional, 'none', &
        'name of the component'), &
        body_field_type(card%check_sphere, 2, 'KIND', form%word, need%always, 'none', &
        '', 'SPHERE'), &
        body_field_type(card%check_sphere, 3, 'STA', form%number, need%always, 'deck unit', &
        'centre'), &
        body_field_type(card%check_sphere, 4, 'BL', form%number, need%always, 'deck unit', &
        'centre'), &
        body_field_type(card%check_sphere, 5, 'WL', form%number, need%always, 'deck unit', &
        'centre'), &
        body_field_type(card%check_sphere, 6, 'R', form%number, need%always, 'deck unit', &
        'radius, above zero'), &
        body_field_type(card%check_sphere, 7, 'CLEAR', form%number, need%always, 'deck unit', &
        'clearance asked, not negative'), &
        body_field_type(card%check_sphere, 8, 'NAME', form%name, need%optional, 'none', &
        'name of the component'), &
        body_field_type(card%check_box, 2, 'KIND', form%word, need%always, 'none', &
        '', 'BOX'), &
        body_field_type(card%check_box, 3, 'STA1', form%number, need%always, 'deck unit', &
        'a corner'), &
        body_field_type(card%check_box, 4, 'BL1', form%number, need%always, 'deck unit', &
        'a corner'), &
        body_field_type(card%check_box, 5, 'WL1', form%number, need%always, 'deck unit', &
        'a corner'), &
        body_field_type(card%check_box, 6, 'STA2', form%number, need%always, 'deck unit', &
        'the opposite corner'), &
        body_field_type(card%check_box, 7, 'BL2', form%number, need%always, 'deck unit', &
        'the opposite corner'), &
        body_field_type(card%check_box, 8, 'WL2', form%number, need%always, 'deck unit', &
        'the opposite corner'), &
        body_field_type(card%check_box, 9, 'CLEAR', form%number, need%always, 'deck unit', &
        'clearance asked, not negative'), &
        body_field_type(card%check_box, 10, 'NAME', form%name, need%optional, 'none', &
        'name of the component')]

end module deck_body_cut_fields
