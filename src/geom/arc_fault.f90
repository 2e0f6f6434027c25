!> Why a control triangle has no conic arc, in words, and what would be right. Whether there is an
!> arc is decided exactly, in `geom_triangle`; only the choice of words allows for lost decimals.
module geom_arc_fault
    use base_error, only: cause, error_type, fail
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_text, only: compact
    use geom_triangle, only: end_type, is_flat, rounding, triangle_type
    use geom_twofold, only: operator(*), operator(/), to_real, twofold_type
    use geom_vector, only: at_text, cross, dot
    implicit none (type, external)
    private

    public :: check_apart, explain_flat, explain_no_arc

contains

    !> Fails with `cause%points_coincide` where two of the three points are one, as far as decimals
    !> can say.
    pure subroutine check_apart(start, shoulder, finish, error)
        type(end_type), intent(in) :: start                 !! first point
        real(dp), intent(in) :: shoulder(2)                 !! shoulder point, deck units
        type(end_type), intent(in) :: finish                !! last point
        type(error_type), allocatable, intent(out) :: error !! see above
        real(dp) :: noise

        noise = rounding(start%point, shoulder, finish%point)
        if (all(abs(finish%point - start%point) <= noise)) then
            call fail(error, cause%points_coincide, 'points 1 and 3 are both '// &
                at_text(start%point)//'; an arc needs two different ends')
        else if (all(abs(shoulder - start%point) <= noise)) then
            call fail(error, cause%points_coincide, 'the shoulder point is point 1 '// &
                at_text(start%point)//'; it must lie between the ends')
        else if (all(abs(shoulder - finish%point) <= noise)) then
            call fail(error, cause%points_coincide, 'the shoulder point is point 3 '// &
                at_text(finish%point)//'; it must lie between the ends')
        end if
    end subroutine check_apart

    !> Says why a triangle whose shoulder point is in line with the ends is no straight line:
    !> always fails, with `cause%shoulder_on_chord`.
    pure subroutine explain_flat(it, error)
        type(triangle_type), intent(in) :: it               !! flat and not straight
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: where_it_is
        real(dp) :: along

        where_it_is = 'the shoulder point '//at_text(it%through)//' is in line with points 1 and 3'
        along = to_real(dot(it%shoulder, it%chord)/dot(it%chord, it%chord))
        if (along <= 0.0_dp .or. along >= 1.0_dp) then
            call fail(error, cause%shoulder_on_chord, where_it_is// &
                ' but not between them; put it between them, off the chord for a curve')
        else
            call fail(error, cause%shoulder_on_chord, &
                where_it_is//' but the end slopes are not; '// &
                'move it off the chord, or for a straight line make both slopes '// &
                trim(slope_text(to_real(it%chord))))
        end if
    end subroutine explain_flat

    !> Says why a triangle whose shoulder point is off the chord has no arc: always fails, with
    !> `cause%tangent_on_chord`, `cause%inflection`, `cause%shoulder_outside` or
    !> `cause%other_branch`.
    pure subroutine explain_no_arc(it, error)
        type(triangle_type), intent(in) :: it               !! not flat, and without an arc
        type(error_type), allocatable, intent(out) :: error !! see above
        character(:), allocatable :: words

        if (is_along_chord(it, it%chord_off_start, it%t1)) then
            call blame_tangent(it, '1', it%t1, error)
        else if (is_along_chord(it, it%chord_off_finish, it%t3)) then
            call blame_tangent(it, '3', it%t3, error)
        else if (needs_inflection(it)) then
            call fail(error, cause%inflection, 'end slopes '//trim(slope_text(it%t1))// &
                ' and '//trim(slope_text(it%t3))//' both turn to the same side of the chord, '// &
                'whose slope is '//trim(slope_text(to_real(it%chord)))//'; that needs an '// &
                'inflection, which a conic has not: divide the curve there, or correct a slope '// &
                'or the shoulder point')
        else if (share(it%off_start, it%chord_off_start) <= 0.0_dp) then
            call blame_shoulder(it, '13', it%off_start, it%t1, error)
        else if (share(it%off_finish, it%chord_off_finish) <= 0.0_dp) then
            call blame_shoulder(it, '31', it%off_finish, it%t3, error)
        else
            call find_inside(it, words)
            call fail(error, cause%other_branch, 'the shoulder point '//at_text(it%through)// &
                ' is so far on the other side of the chord that points 1 and 3 are on '// &
                'different branches of the conic; it must lie '//words)
        end if
    end subroutine explain_no_arc

    !> True where an end tangent can't be told from the chord.
    pure logical function is_along_chord(it, product, tangent)
        type(triangle_type), intent(in) :: it     !! a control triangle
        type(twofold_type), intent(in) :: product !! chord x tangent, either sign
        real(dp), intent(in) :: tangent(2)        !! the tangent
        is_along_chord = abs(to_real(product)) <= it%noise*norm2(tangent)
    end function is_along_chord

    !> True where both end tangents, pointed forward along the chord, turn to the same side of it.
    pure logical function needs_inflection(it)
        type(triangle_type), intent(in) :: it !! a control triangle
        needs_inflection = side(it%t1)*side(it%t3) > 0.0_dp
    contains
        !> 1 where a tangent turns left of the chord, -1 right, 0 where it has no forward end.
        pure real(dp) function side(tangent)
            real(dp), intent(in) :: tangent(2) !! the tangent
            real(dp) :: turn, forward
            turn = to_real(cross(it%chord, tangent))
            forward = to_real(dot(it%chord, tangent))
            side = sign(1.0_dp, turn)*sign(1.0_dp, forward)
            if (is_zero(turn) .or. is_zero(forward)) side = 0.0_dp
        end function side
    end function needs_inflection

    !> A barycentric coordinate of the shoulder point.
    pure real(dp) function share(shoulder_off, chord_off)
        type(twofold_type), intent(in) :: shoulder_off !! from the tangent, signed
        type(twofold_type), intent(in) :: chord_off    !! from the tangent, signed, not zero
        share = to_real(shoulder_off/chord_off)
    end function share

    !> An end tangent is along the chord: `cause%tangent_on_chord`.
    pure subroutine blame_tangent(it, name, tangent, error)
        type(triangle_type), intent(in) :: it               !! a control triangle
        character(*), intent(in) :: name                    !! number of the point
        real(dp), intent(in) :: tangent(2)                  !! the tangent there
        type(error_type), allocatable, intent(out) :: error !! always
        character(:), allocatable :: words
        words = 'the tangent at point '//name//', slope '//trim(slope_text(tangent))// &
            ', runs along the chord, but the shoulder point '//at_text(it%through)// &
            ' is off it; turn the tangent to the side of the shoulder point'
        if (is_flat(it)) words = words//', or put the shoulder point on the chord for a '// &
            'straight line'
        call fail(error, cause%tangent_on_chord, words)
    end subroutine blame_tangent

    !> A shoulder point is on or beyond an end tangent: `cause%shoulder_outside`.
    pure subroutine blame_shoulder(it, names, off, tangent, error)
        type(triangle_type), intent(in) :: it               !! a control triangle
        character(2), intent(in) :: names                   !! numbers of the point whose tangent
                                                            !! it is, and of the other end
        type(twofold_type), intent(in) :: off               !! shoulder point from the tangent
        real(dp), intent(in) :: tangent(2)                  !! the tangent
        type(error_type), allocatable, intent(out) :: error !! always
        character(:), allocatable :: words, inside

        words = ' on the other side of the tangent at point '//names(1:1)//' from '// &
            'point '//names(2:2)
        if (abs(to_real(off)) <= it%noise*norm2(tangent)) &
            words = ' on the tangent at point '//names(1:1)
        call find_inside(it, inside)
        call fail(error, cause%shoulder_outside, 'the shoulder point '//at_text(it%through)// &
            ' lies'//words//', slope '//trim(slope_text(tangent))//'; it must lie '//inside)
    end subroutine blame_shoulder

    !> Where the shoulder point belongs.
    pure subroutine find_inside(it, words)
        type(triangle_type), intent(in) :: it           !! a control triangle, no tangent along the
                                                        !! chord
        character(:), allocatable, intent(out) :: words !! the end of a sentence
        real(dp) :: reach, corner(2), middle(2)

        if (abs(to_real(it%tangents)) <= it%noise*norm2(it%t1)*norm2(it%t3)) then
            words = 'between the parallel end tangents'
            return
        end if
        reach = -to_real(it%chord_off_finish/it%tangents)
        corner = it%start%point + it%size*(reach*it%t1)
        middle = it%start%point + 0.5_dp*(it%finish%point - it%start%point)
        words = 'inside the triangle of points 1 and 3 and the intersection of the end '// &
            'tangents at '//at_text(corner)//'; rho .5 has it at '// &
            at_text(middle + 0.5_dp*(corner - middle))
    end subroutine find_inside

    !> A direction as a slope: `0.5`, `vertical`; blanks behind it.
    pure function slope_text(direction) result(text)
        real(dp), intent(in) :: direction(2) !! not zero
        character(32) :: text
        if (abs(direction(1)) <= tiny(1.0_dp)*abs(direction(2)) .or. is_zero(direction(1))) then
            text = 'vertical'
        else
            text = compact(direction(2)/direction(1))
        end if
    end function slope_text

end module geom_arc_fault
