!> Lists that grow keep all items in their order, however often they were full.
program test_job_list
    use deck_body_card, only: card_type, sheet_type
    use deck_job, only: body_type, check_type, control_line_type, cut_type, piece_type, section_type
    use deck_job_list, only: append
    use support_tap, only: tap_type
    implicit none (type, external)

    integer, parameter :: many = 100
    type(tap_type) :: tap
    type(body_type), allocatable :: bodies(:)
    type(card_type), allocatable :: cards(:)
    type(check_type), allocatable :: checks(:)
    type(control_line_type), allocatable :: lines(:)
    type(cut_type), allocatable :: cuts(:)
    type(piece_type), allocatable :: pieces(:)
    type(section_type), allocatable :: sections(:)
    type(piece_type) :: piece
    type(control_line_type) :: line
    integer :: counts(7), i

    counts = 0
    do i = 1, many
        piece%kind = i
        if (allocated(piece%value)) deallocate (piece%value)
        allocate (piece%value(modulo(i, 7)))
        call append(pieces, counts(1), piece)
        line%name = name_of(i)
        line%view(1)%piece = [piece]
        call append(lines, counts(2), line)
        call append(sections, counts(3), section_type(name=name_of(i)))
        call append(cuts, counts(4), cut_type(kind=i))
        call append(checks, counts(5), check_type(kind=i))
        call append(bodies, counts(6), body_type(name=name_of(i)))
        call append(cards, counts(7), card_type(sheet=[sheet_type(image=name_of(i))]))
    end do
    call tap%ok(all(counts == many), 'all items are counted')
    call tap%ok(all(pieces(:many)%kind == [(i, i = 1, many)]), 'pieces stay in order')
    call tap%ok(all([(size(pieces(i)%value) == modulo(i, 7), i = 1, many)]), 'with their numbers')
    call tap%ok(all([(lines(i)%name == name_of(i), i = 1, many)]), 'lines stay in order')
    call tap%ok(all([(lines(i)%view(1)%piece(1)%kind == i, i = 1, many)]), 'with their pieces')
    call tap%ok(all([(sections(i)%name == name_of(i), i = 1, many)]), 'sections stay in order')
    call tap%ok(all(cuts(:many)%kind == [(i, i = 1, many)]), 'cuts stay in order')
    call tap%ok(all(checks(:many)%kind == [(i, i = 1, many)]), 'components stay in order')
    call tap%ok(all([(bodies(i)%name == name_of(i), i = 1, many)]), 'bodies stay in order')
    call tap%ok(all([(cards(i)%sheet(1)%image == name_of(i), i = 1, many)]), &
        'cards stay in order')
    call tap%finish()

contains

    !> A name of its own for each item.
    pure function name_of(i) result(name)
        integer, intent(in) :: i
        character(8) :: name
        write (name, '(a,i0)') 'N', i
    end function name_of

end program test_job_list
