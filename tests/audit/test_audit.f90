!> The audit of whole lines: the tables of SAE 700202 as they were scanned, and random ones.
program test_audit
    use audit_audit, only: audit_type, make_audit
    use audit_figure, only: bare, form, scale_type
    use audit_finding, only: verdict
    use audit_parameter, only: find_pairs, pair_type
    use audit_printing, only: printing
    use audit_reading, only: add, line_type, meaning, new_reading, reading_type, sort
    use base_error, only: cause, error_type
    use base_kinds, only: dp
    use support_audit_rates, only: measure_rates, rates_type, trial_type
    use support_book, only: figure_type, read_coefficients, read_figures
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(audit_type) :: audit
    type(line_type) :: line
    type(error_type), allocatable :: error
    type(figure_type), allocatable :: figures(:)
    type(rates_type) :: rates

    allocate (figures(0))
    figures = read_figures('golden/book/tables.csv')
    call prove('MHB side', ['-10.0', ' .114', '-7.1 ', '-4.0 ', ' .052'], '0.0523')
    call prove('LSH side', ['-10.0', '-.268', '-16.0', '-21.2', '-.070'], '-0.0697')
    call prove('LCL side', ['-10.0', '-.384', '-18.0', '-24.1', '-.087'], '-0.0871')
    call prove('MHB plan', ['0.0 ', '.577', '11.9', '21.5', '.140'], '0.1405')
    call prove('LSH plan', ['0.0 ', '.404', '-9.0', '18.2', '.132'], '0.1316')
    call tap%ok(audit%finding(9)%verdict == verdict%suspect .and. &
        audit%finding(9)%likely == '9.0', &
        'the sign of the shoulder point of LSH plan is found wrong')
    call prove_pairs()
    call prove_coefficients()
    call prove_section('STA 0 contour', ['-18.0 ', '-18.0 ', '-7.1  '], [9.0_dp, 11.901_dp])
    call tap%ok(audit%finding(12)%verdict == verdict%suspect .and. &
        audit%piece(1)%card%number(3) == '-15.999', 'the shoulder point of STA 0 is put right')
    call prove_section('STA 10', ['-19.638', '-17.383', '-6.358 '], [11.271_dp, 14.415_dp])
    call prove_section('STA 20', ['-20.999', '-18.563', '-5.898 '], [13.312_dp, 16.544_dp])
    call tap%ok(audit%finding(9)%verdict == verdict%suspect .and. &
        audit%finding(9)%low <= -5.698_dp .and. audit%finding(9)%high >= -5.698_dp .and. &
        audit%finding(9)%sure < 0.9_dp, &
        'the last point of STA 20 is found wrong; what is right is left open')

    deallocate (line%reading)
    call add(line, new_reading(sort%ordinate, 1.0_dp, '0.1'))
    call make_audit(line, audit, error)
    call tap%ok(allocated(error), 'one figure is no line')
    if (allocated(error)) call tap%ok(error%cause == cause%too_few, '... for want of more')

    call measure_rates(trial_type(conics=1, lines=80, damaged=0.15_dp), rates)
    call tap%ok(rates%found() > 0.99_dp, 'at 15 % damage 99 % of slips of two units are found')
    call tap%ok(rates%accused() < 0.005_dp, 'fewer than .5 % of sound figures are accused')
    call tap%ok(rates%restored() > 0.90_dp, '90 % of one-character slips are restored')
    call measure_rates(trial_type(conics=2, lines=25, damaged=0.15_dp), rates)
    call tap%ok(rates%found() > 0.99_dp .and. rates%accused() < 0.005_dp .and. &
        rates%restored() > 0.90_dp, 'all of that holds for chains of two conics')
    call measure_rates(trial_type(lines=40, damaged=0.40_dp, known=2), rates)
    call tap%ok(rates%found() > 0.99_dp .and. rates%accused() < 0.005_dp .and. &
        rates%restored() > 0.90_dp, 'and at 40 % damage where ends and slopes are known')
    call tap%finish()

contains

    !> Proves a line of Table 2 as scanned, its card as Table 1 prints it.
    subroutine prove(name, card, s3)
        character(*), intent(in) :: name    !! of the line
        character(*), intent(in) :: card(5) !! Y1, S1, Y2, Y3, S3
        character(*), intent(in) :: s3      !! the last slope as it was punched
        logical :: all_found, none_accused, all_restored
        integer :: i, n

        call read_line(name, card)
        call make_audit(line, audit, error)
        call tap%ok(.not. allocated(error), name//': a line is found')
        all_found = .true.
        none_accused = .true.
        all_restored = .true.
        n = 0
        do i = 1, size(figures)
            if (figures(i)%line /= name) cycle
            n = n + 1
            associate (it => audit%finding(n), scanned => figures(i)%scanned, &
                    restored => figures(i)%restored)
                if (scanned == restored) then
                    none_accused = none_accused .and. it%verdict == verdict%agrees
                else
                    all_found = all_found .and. it%verdict /= verdict%agrees
                    if (one_character(scanned, restored)) &
                        all_restored = all_restored .and. bare(it%likely) == bare(restored)
                end if
            end associate
        end do
        call tap%ok(all_found, name//': every damaged figure is found')
        call tap%ok(none_accused, name//': no sound one is accused')
        call tap%ok(all_restored, name//': those with one damaged character are restored')
        call tap%ok(size(audit%piece(1)%parameter(5)%round) == 1, name//': one S3 is round')
        call tap%same(trim(audit%piece(1)%parameter(5)%round(1)), s3, name//': as punched')
    end subroutine prove

    !> True where two figures differ in one character, left out, put in or taken for another.
    pure logical function one_character(a, b)
        character(*), intent(in) :: a !! a figure
        character(*), intent(in) :: b !! another
        integer :: i, m, n, wrong
        m = len_trim(a)
        n = len_trim(b)
        one_character = .false.
        wrong = 0
        do i = 1, m
            if (m == n .and. a(i:i) /= b(i:i)) wrong = wrong + 1
            if (m == n + 1) one_character = one_character .or. a(:i - 1)//a(i + 1:m) == b(:n)
        end do
        if (m == n) one_character = wrong == 1
    end function one_character

    !> Reads the rows of a line, and puts its card behind them.
    subroutine read_line(name, card)
        character(*), intent(in) :: name    !! of the line
        character(*), intent(in) :: card(5) !! Y1, S1, Y2, Y3, S3
        real(dp) :: along
        integer :: i

        line = line_type(name=name, scale=scale_type(form%decimal, 3), printing=printing%of_1970)
        do i = 1, size(figures)
            if (figures(i)%line /= name) cycle
            read (figures(i)%along, *) along
            call add(line, new_reading(sort%ordinate, along, figures(i)%scanned))
            line%reading(size(line%reading))%column = merge(2, 1, name == 'MHB side' .and. &
                figures(i)%column == 'root1')
        end do
        call add(line, new_reading(sort%ordinate, -30.0_dp, card(1), meaning%exact))
        call add(line, new_reading(sort%ordinate, 0.0_dp, card(3), meaning%exact))
        call add(line, new_reading(sort%ordinate, 50.0_dp, card(4), meaning%exact))
        call add(line, new_reading(sort%slope, -30.0_dp, card(2), meaning%exact))
        call add(line, new_reading(sort%slope, 50.0_dp, card(5), meaning%rounded))
    end subroutine read_line

    !> With S1 of LSH plan known to three decimals, two pairs of four-digit slopes are possible.
    subroutine prove_pairs()
        type(pair_type), allocatable :: pairs(:)
        integer :: n
        n = size(line%reading)
        line%reading(n - 1)%meaning = meaning%rounded
        call make_audit(line, audit, error)
        allocate (pairs(0))
        associate (piece => audit%piece(1))
            call tap%ok(piece%parameter(2)%low >= 0.4035_dp - 1.0e-9_dp .and. &
                piece%parameter(2)%high <= 0.4045_dp + 1.0e-9_dp, &
                'S1 of LSH plan, printed .404, is given as an interval')
            pairs = find_pairs(piece%fit, piece%parameter(2)%quantity, &
                piece%parameter(5)%quantity, 4)
        end associate
        call tap%ok(has_pair(pairs, '0.4040', '0.1316'), '.404 with .1316 is possible')
        call tap%ok(has_pair(pairs, '0.4035', '0.1317'), '.4035 with .1317 is possible')
        call tap%ok(size(pairs) <= 8, 'few other pairs are, of 110 that print as .404 and .132')
    end subroutine prove_pairs

    !> The printed coefficients of MHB side and its rows on both sides: all damage is put right.
    subroutine prove_coefficients()
        type(figure_type), allocatable :: printed(:)
        type(reading_type) :: reading
        logical :: all_right
        integer :: i, n

        allocate (printed(0))
        printed = read_coefficients('golden/book/inputs.csv')
        call read_line('MHB side', ['-10.0', ' .114', '-7.1 ', '-4.0 ', ' .052'])
        n = size(line%reading)
        do i = 1, size(printed)
            reading = new_reading(sort%coefficient, 0.0_dp, printed(i)%scanned)
            reading%letter = iachar(printed(i)%along(1:1)) - iachar('A') + 1
            call add(line, reading)
        end do
        call make_audit(line, audit, error)
        all_right = size(printed) == 5
        do i = 1, size(printed)
            all_right = all_right .and. bare(audit%finding(n + i)%likely) == &
                bare(printed(i)%restored)
        end do
        call tap%ok(all_right, 'the damaged coefficients A and B of MHB side are restored')
        n = 0
        do i = 1, size(figures)
            if (figures(i)%line /= 'MHB side') cycle
            n = n + 1
            all_right = all_right .and. bare(audit%finding(n)%likely) == bare(figures(i)%restored)
        end do
        call tap%ok(all_right, 'and so are all its 30 ordinates')
        call tap%near(audit%piece(1)%parameter(5)%high - audit%piece(1)%parameter(5)%low, 0.0_dp, &
            1.0e-6_dp, 'its S3 is .0523 to a millionth')
    end subroutine prove_coefficients

    !> Proves a cross-section of Table 4 as scanned, with its points as Table 3 prints them.
    subroutine prove_section(name, y, x)
        character(*), intent(in) :: name !! of the section
        character(*), intent(in) :: y(3) !! its points, as scanned
        real(dp), intent(in) :: x(2)     !! abscissae of the second and third
        real(dp) :: along
        logical :: all_right, none_accused
        integer :: i, n

        line = line_type(name=name, scale=scale_type(form%decimal, 3), printing=printing%of_1970)
        do i = 1, size(figures)
            if (figures(i)%line /= name) cycle
            read (figures(i)%along, *) along
            call add(line, new_reading(merge(sort%ordinate, sort%abscissa, &
                figures(i)%axis == 'X'), along, figures(i)%scanned))
        end do
        call add(line, new_reading(sort%ordinate, 0.0_dp, y(1), meaning%exact))
        call add(line, new_reading(sort%ordinate, x(1), y(2), meaning%exact))
        call add(line, new_reading(sort%ordinate, x(2), y(3), meaning%exact))
        call add(line, new_reading(sort%slope, 0.0_dp, '0', meaning%exact))
        call add(line, new_reading(sort%slope, x(2), '999.999', meaning%exact))
        call make_audit(line, audit, error)
        all_right = .not. allocated(error)
        none_accused = all_right
        n = 0
        do i = 1, size(figures)
            if (figures(i)%line /= name) cycle
            n = n + 1
            all_right = all_right .and. bare(audit%finding(n)%likely) == bare(figures(i)%restored)
            if (figures(i)%scanned == figures(i)%restored) none_accused = none_accused .and. &
                audit%finding(n)%verdict == verdict%agrees
        end do
        call tap%ok(all_right, name//': every figure is right or put right')
        call tap%ok(none_accused, name//': no sound one is accused')
    end subroutine prove_section

    !> True where a pair is among others.
    pure logical function has_pair(pairs, first, second) result(has)
        type(pair_type), intent(in) :: pairs(:) !! any
        character(*), intent(in) :: first       !! one number
        character(*), intent(in) :: second      !! the other
        integer :: i
        has = .false.
        do i = 1, size(pairs)
            has = has .or. (pairs(i)%first == first .and. pairs(i)%second == second)
        end do
    end function has_pair

end program test_audit
