!> The skin in STEP files: what is counted follows from Euler's formula and from the solids at hand.
program test_step_shell
    use base_kinds, only: dp
    use export_receipt, only: receipt_type
    use export_shell, only: skin_model_type
    use export_step_shell, only: add_skin, skin_items_type
    use export_step_text, only: step_file_type
    use support_sewn, only: ball_skin, box_skin
    use support_step_records, only: count_of, record_named, record_type, records_of, refers_back
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap

    call check_box()
    call check_ball()
    call check_open()
    call check_nothing()
    call tap%finish()

contains

    subroutine check_box()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        type(skin_items_type) :: items
        type(receipt_type) :: receipt

        call add_skin(file, box_skin([0.0_dp, -1.0_dp, -2.0_dp], [10.0_dp, 1.0_dp, 3.0_dp]), &
            .false., items, receipt)
        records = records_of(file%text())
        call tap%ok(refers_back(records), 'instances in order')
        call tap%ok(size(items%solids) == 1 .and. size(items%sheets) == 0, 'a box is a solid')
        call tap%ok(index(record_named(records, items%solids(1)), 'MANIFOLD_SOLID_BREP(') == 1, &
            'and named so')
        call tap%ok(count_of(records, 'VERTEX_POINT') == 8 .and. &
            count_of(records, 'EDGE_CURVE') == 12 .and. count_of(records, 'ADVANCED_FACE') == 6, &
            'it has 8 corners, 12 edges and 6 faces')
        call tap%ok(count_of(records, 'ORIENTED_EDGE') == 24, 'each edge has two sides')
        call tap%ok(count_of(records, 'LINE') == 12, 'all edges are straight')
        call tap%ok(uses_twice(records), 'one side of each edge runs as it does, one against it')
        call tap%ok(receipt%count == 6 .and. receipt%entities(1)%name == 'FACE 1' .and. &
            receipt%entities(1)%kind == 'B_SPLINE_SURFACE_WITH_KNOTS' .and. &
            receipt%entities(1)%points == 4 .and. receipt%entities(1)%spans == 1 .and. &
            receipt%entities(5)%kind == 'PLANE' .and. receipt%entities(5)%points == 0 .and. &
            receipt%entities(5)%is_exact, 'the receipt lists the faces')
    end subroutine check_box

    subroutine check_ball()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        type(skin_items_type) :: items
        type(receipt_type) :: receipt
        type(skin_model_type) :: skin

        skin = ball_skin(2.0_dp)
        skin%faces(3)%is_exact = .false.
        skin%faces(3)%error = 1.0e-4_dp
        skin%faces(3)%worst = [1.0_dp, 2.0_dp, 3.0_dp]
        skin%faces(4)%is_outward = .true.
        call add_skin(file, skin, .false., items, receipt)
        records = records_of(file%text())
        call tap%ok(count_of(records, 'VERTEX_POINT') == 6 .and. &
            count_of(records, 'EDGE_CURVE') == 12 .and. count_of(records, 'ADVANCED_FACE') == 8, &
            'a ball of octants has 6 corners, 12 edges and 8 faces')
        call tap%ok(count_of(records, 'ORIENTED_EDGE') == 24, 'sides that are points are left out')
        call tap%ok(uses_twice(records), 'edges run once each way')
        call tap%ok(receipt%entities(3)%error == 1.0e-4_dp .and. receipt%entities(3)%has_place &
            .and. all(receipt%entities(3)%worst == [1.0_dp, 2.0_dp, 3.0_dp]) .and. &
            .not. receipt%entities(3)%is_exact .and. .not. receipt%entities(2)%has_place, &
            'the receipt tells a fitted face from an exact one')
        call tap%ok(count_text(file%text(), '.F.);') == 12 + 7 .and. &
            count_text(file%text(), '.T.);') == 12 + 12 + 8 + 1, &
            'a face says which way its surface turns')
    end subroutine check_ball

    subroutine check_open()
        type(step_file_type) :: file
        type(record_type), allocatable :: records(:)
        type(skin_items_type) :: items
        type(receipt_type) :: receipt
        type(skin_model_type) :: skin

        skin = ball_skin(2.0_dp)
        call add_skin(file, skin, .true., items, receipt)
        records = records_of(file%text())
        call tap%ok(size(items%solids) == 0 .and. size(items%sheets) == 1, &
            'where sheets are asked for there is no solid')
        call tap%ok(count_of(records, 'CLOSED_SHELL') == 1, 'a shell that closes is still closed')
        skin%shells(1)%faces = [1, 3, 5, 7]
        skin%shells(1)%is_closed = .false.
        call add_skin(file, skin, .false., items, receipt)
        records = records_of(file%text())
        call tap%ok(size(items%solids) == 0 .and. size(items%sheets) == 1 .and. &
            count_of(records, 'OPEN_SHELL') == 1, 'a shell that does not close is open')
        call tap%ok(count_of(records, 'ADVANCED_FACE') == 8 + 4, 'only its own faces are written')
        call tap%ok(index(record_named(records, items%sheets(1)), &
            'SHELL_BASED_SURFACE_MODEL(''SKIN'',(#') == 1, 'it is a surface model')
    end subroutine check_open

    subroutine check_nothing()
        type(step_file_type) :: file
        type(skin_items_type) :: items
        type(receipt_type) :: receipt
        type(skin_model_type) :: skin

        call add_skin(file, skin, .false., items, receipt)
        call tap%ok(size(items%solids) + size(items%sheets) == 0 .and. file%text() == '' .and. &
            receipt%count == 0, 'where there is no skin nothing is added')
    end subroutine check_nothing

    !> True where each edge has two sides, one along it and one against it.
    logical function uses_twice(records)
        type(record_type), intent(in) :: records(:) !! a data section
        character(:), allocatable :: all_text
        integer :: i
        character(12) :: number

        all_text = ''
        do i = 1, size(records)
            all_text = all_text//records(i)%text//new_line('a')
        end do
        uses_twice = .true.
        do i = 1, size(records)
            if (index(records(i)%text, 'EDGE_CURVE(') /= 1) cycle
            write (number, '(a,i0)') '#', i
            uses_twice = uses_twice .and. &
                count_text(all_text, 'ORIENTED_EDGE('''',*,*,'//trim(number)//',.T.)') == 1 .and. &
                count_text(all_text, 'ORIENTED_EDGE('''',*,*,'//trim(number)//',.F.)') == 1
        end do
    end function uses_twice

    !> How often a text has another in it.
    pure integer function count_text(text, part) result(count)
        character(*), intent(in) :: text !! where to look
        character(*), intent(in) :: part !! what for
        integer :: at, next
        count = 0
        at = 1
        do
            next = index(text(at:), part)
            if (next == 0) return
            count = count + 1
            at = at + next
        end do
    end function count_text

end program test_step_shell
