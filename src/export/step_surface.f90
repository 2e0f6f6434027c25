!> Surfaces of a STEP file (ISO 10303-42, clause 4): B-splines and planes.
module export_step_surface
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_text, only: to_text
    use export_shell, only: face_type
    use export_step_curve, only: add_placement, add_point, knot_words
    use export_step_text, only: step_file_type, step_list, step_logical, step_reference, &
        step_references, step_string
    use geom_bspline_surface, only: bspline_surface_type
    implicit none (type, external)
    private

    public :: add_surface, surface_word

contains

    !> Adds the surface of a face.
    subroutine add_surface(file, face, number)
        type(step_file_type), intent(inout) :: file !! gets it
        type(face_type), intent(in) :: face         !! of a skin
        integer, intent(out) :: number              !! of the instance
        integer :: place

        if (face%is_flat) then
            call add_placement(file, face%origin, face%normal, place)
            call file%add('PLANE('''','//step_reference(place)//')', number)
        else
            call add_spline_surface(file, face%surface, face%name, number)
        end if
    end subroutine add_surface

    !> Adds a B-spline surface, plain where it is a polynomial one.
    subroutine add_spline_surface(file, surface, name, number)
        type(step_file_type), intent(inout) :: file         !! gets it
        type(bspline_surface_type), intent(in) :: surface   !! in space
        character(*), intent(in) :: name                    !! any bytes
        integer, intent(out) :: number                      !! of the instance
        character(:), allocatable :: form, knots

        call add_poles(file, surface%pole, form)
        form = to_text(surface%degree(1))//','//to_text(surface%degree(2))//','//form// &
            ',.UNSPECIFIED.,'//closure(surface)//',.F.'
        knots = knot_rows(surface)
        if (is_rational(surface)) then
            call file%add('(BOUNDED_SURFACE()B_SPLINE_SURFACE('//form// &
                ')B_SPLINE_SURFACE_WITH_KNOTS('//knots// &
                ',.UNSPECIFIED.)GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE('// &
                weights(surface)//')REPRESENTATION_ITEM('//step_string(name)//')SURFACE())', number)
        else
            call file%add('B_SPLINE_SURFACE_WITH_KNOTS('//step_string(name)//','//form//','// &
                knots//',.UNSPECIFIED.)', number)
        end if
    end subroutine add_spline_surface

    !> Adds the poles of a surface.
    subroutine add_poles(file, pole, list)
        type(step_file_type), intent(inout) :: file         !! gets them
        real(dp), intent(in) :: pole(:, :, :)               !! shape (3, u poles, v poles)
        character(:), allocatable, intent(out) :: list      !! a list over u of lists over v
        integer :: numbers(size(pole, 3)), i, j

        list = ''
        do i = 1, size(pole, 2)
            do j = 1, size(pole, 3)
                call add_point(file, pole(:, i, j), numbers(j))
            end do
            list = list//','//step_references(numbers)
        end do
        list = '('//list(2:)//')'
    end subroutine add_poles

    !> The weights of a surface: a list over u of lists over v.
    pure function weights(surface) result(list)
        type(bspline_surface_type), intent(in) :: surface !! any
        character(:), allocatable :: list
        integer :: i

        list = ''
        do i = 1, size(surface%weight, 1)
            list = list//','//step_list(surface%weight(i, :))
        end do
        list = '('//list(2:)//')'
    end function weights

    !> How often knots stand, along u and v, and the different ones, along u and v.
    pure function knot_rows(surface) result(words)
        type(bspline_surface_type), intent(in) :: surface !! any
        character(:), allocatable :: words
        character(:), allocatable :: u, v

        u = knot_words(surface%u_knot)
        v = knot_words(surface%v_knot)
        words = u(:index(u, ')'))//','//v(:index(v, ')'))//u(index(u, ')') + 1:)// &
            v(index(v, ')') + 1:)
    end function knot_rows

    !> Whether a surface closes along u, and along v.
    pure function closure(surface) result(words)
        type(bspline_surface_type), intent(in) :: surface !! any
        character(7) :: words
        integer :: u, v

        u = size(surface%pole, 2)
        v = size(surface%pole, 3)
        words = step_logical(all(is_equal(surface%pole(:, 1, :), surface%pole(:, u, :))))//','// &
            step_logical(all(is_equal(surface%pole(:, :, 1), surface%pole(:, :, v))))
    end function closure

    !> True where the weights of a surface differ.
    pure logical function is_rational(surface)
        type(bspline_surface_type), intent(in) :: surface !! any
        is_rational = .not. all(is_equal(surface%weight, surface%weight(1, 1)))
    end function is_rational

    !> What the surface of a face is in STEP.
    pure function surface_word(face) result(word)
        type(face_type), intent(in) :: face !! of a skin
        character(:), allocatable :: word

        word = 'PLANE'
        if (face%is_flat) return
        word = 'B_SPLINE_SURFACE_WITH_KNOTS'
        if (is_rational(face%surface)) word = 'RATIONAL_B_SPLINE_SURFACE'
    end function surface_word

end module export_step_surface
