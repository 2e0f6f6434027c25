!> The end of the listing of an audit: what its tables say of one another, and how many figures were
!> found good or bad.
module audit_cross_listing
    use audit_cross, only: cross_type, table_title
    use audit_deck, only: deck_audit_type
    use audit_finding, only: verdict, verdict_name
    use base_digits, only: fixed
    use base_kinds, only: i64
    use base_output, only: output_type
    use base_text, only: counted, to_text, upper
    use report_page, only: page_type
    implicit none (type, external)
    private

    public :: print_cross, print_summary

    !> Columns that a number of units is shown in.
    integer, parameter :: units_width = 12

contains

    !> Prints what tables say of one another.
    subroutine print_cross(page, found, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(deck_audit_type), intent(in) :: found      !! what was found
        type(output_type), intent(inout) :: out         !! where it goes
        character(:), allocatable :: words
        integer :: k

        if (size(found%cross) == 0) return
        call page%keep(out, 8)
        call page%line(out, 'TABLES HELD AGAINST ONE ANOTHER')
        call page%line(out, 'A figure in brackets is suspect, one with = is of the line found.')
        call page%blank(out)
        do k = 1, size(found%cross)
            call say_cross(found, found%cross(k), words)
            call page%paragraph(out, words)
        end do
        call page%blank(out)
    end subroutine print_cross

    !> Says in words what two tables say of an ordinate.
    pure subroutine say_cross(found, cross, words)
        type(deck_audit_type), intent(in) :: found      !! what was found
        type(cross_type), intent(in) :: cross           !! of two tables
        character(:), allocatable, intent(out) :: words !! the sentence
        character(:), allocatable :: text
        integer :: k

        words = merge('AGREES   ', 'DIFFERS  ', cross%agrees)//trim(cross%what)//': '
        do k = 1, 2
            associate (side => cross%side(k))
                text = trim(side%text)
                if (.not. side%is_printed) text = '='//text
                if (.not. side%is_sound) text = '('//text//')'
                words = words//table_title(found%item(side%table))//' '//text
            end associate
            if (k == 1) words = words//', '
        end do
        if (.not. cross%agrees) words = words//'; '// &
            trim(adjustl(fixed(cross%apart, units_width, 1)))//' UNITS APART'
    end subroutine say_cross

    !> Prints how many figures were found how.
    subroutine print_summary(page, found, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(deck_audit_type), intent(in) :: found      !! what was found
        type(output_type), intent(inout) :: out         !! where it goes
        character(:), allocatable :: words
        integer :: number(0:5), i, k

        number = 0
        do i = 1, size(found%item)
            if (.not. found%item(i)%is_audited) then
                number(0) = number(0) + count(found%item(i)%entry > 0)
                cycle
            end if
            do k = 1, size(found%item(i)%entry)
                if (found%item(i)%entry(k) == 0) cycle
                associate (at => found%item(i)%audit%finding(k)%verdict)
                    number(at) = number(at) + 1
                end associate
            end do
            do k = 1, 2
                associate (at => found%step(k, i)%verdict)
                    if (at /= verdict%none) number(at) = number(at) + 1
                end associate
            end do
        end do
        words = upper(counted(int(sum(number), i64), 'figure'))//':'
        do k = 0, 5
            if (number(k) > 0) words = words//' '//to_text(number(k))//' '// &
                upper(verdict_name(k))//','
        end do
        call page%line(out, words(:len(words) - 1))
    end subroutine print_summary

end module audit_cross_listing
