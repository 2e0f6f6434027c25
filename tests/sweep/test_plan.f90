!> Plans: the order of a grid, the strata of a Latin hypercube, lists, and what is refused.
program test_plan
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use deck_job, only: job_type
    use support_job_deck, only: body_text, job_of, words_of
    use support_tap, only: tap_type
    use sweep_plan, only: new_plan, plan_type, values_of
    implicit none (type, external)

    character(*), parameter :: a = 'LINE,A,SIDE,5.|VARY,FROM,A,1.,2.,3|', &
        b = 'LINE,B,SIDE,5.|VARY,LIST,FROM,B,10.,-4.5|'
    type(tap_type) :: tap
    type(plan_type) :: plan

    call grid()
    call latin()
    call narrow_strata()
    call lists()
    call refusals()
    call tap%finish()

contains

    !> The plan of the cards behind a body.
    subroutine make(cards, said)
        character(*), intent(in) :: cards
        character(:), allocatable, intent(out) :: said
        type(job_type) :: job
        type(fault_list_type) :: faults
        call job_of(body_text//cards//'STATION,1', job, faults)
        if (faults%has_errors(0)) call tap%note(words_of(faults))
        call new_plan(job%sweep, plan, faults)
        said = words_of(faults)
    end subroutine make

    subroutine grid()
        character(:), allocatable :: said
        real(dp) :: found(2, 6)
        integer :: i
        call make(a//b, said)
        call tap%same(said, '', 'a grid is made without a SWEEP card')
        call tap%ok(plan%count == 6, 'it has all with all')
        found = reshape([(values_of(plan, i), i = 1, 6)], [2, 6])
        call tap%ok(all(abs(found(1, :) - [1.0_dp, 1.0_dp, 1.5_dp, 1.5_dp, 2.0_dp, &
            2.0_dp]) <= 0.0_dp), &
            'the first variable changes last')
        call tap%ok(all(abs(found(2, :) - [10.0_dp, -4.5_dp, 10.0_dp, -4.5_dp, 10.0_dp, -4.5_dp]) &
            <= 0.0_dp), 'the last with every variant')
        call make('LINE,A,SIDE,5.|VARY,FROM,A,0.,1.,4|', said)
        found(1, 1:1) = values_of(plan, 2)
        call tap%near(found(1, 1), 0.3333333_dp, 0.0_dp, 'a value has the figures of its field')
        found(1, 1:1) = values_of(plan, 4)
        call tap%near(found(1, 1), 1.0_dp, 0.0_dp, 'the end is the end')
    end subroutine grid

    !> Each stratum of each variable is met once, whatever the seed.
    subroutine latin()
        integer, parameter :: number = 97
        character(:), allocatable :: said
        real(dp) :: value(3, number), first(3, number)
        integer :: i, k, seed, missed
        character(2) :: text

        missed = 0
        do seed = 1, 20
            write (text, '(i0)') seed
            call make('SWEEP,LATIN,97,'//text//'|'//a//b// &
                'LINE,C,SIDE,5.|VARY,FROM,C,-30.,67.|', said)
            do i = 1, number
                value(:, i) = values_of(plan, i)
            end do
            if (seed == 1) first = value
            do k = 0, number - 1
                if (count(floor((value(1, :) - 1.0_dp)*97.0_dp + 1.0e-9_dp) == k) /= 1) &
                    missed = missed + 1
                if (count(floor(value(3, :) + 30.0_dp) == k) /= 1) missed = missed + 1
                if (count(ceiling(plan%share(:, 2)*97.0_dp) == k + 1) /= 1) missed = missed + 1
            end do
        end do
        call tap%same(said, '', 'a Latin hypercube is made')
        call tap%ok(plan%count == number, 'with as many variants as are asked for')
        call tap%ok(missed == 0, 'each stratum of each variable is met once')
        call tap%ok(any(abs(first - value) > 0.0_dp), 'another seed is another hypercube')
        call tap%ok(count(value(2, :) > 0.0_dp) == 48 .or. count(value(2, :) > 0.0_dp) == 49, &
            'the values of a list have equal shares')
        call tap%ok(abs(cor(value(1, :), value(3, :))) < 0.4_dp, 'variables do not go together')
    end subroutine latin

    !> Strata 1/16 wide, whose bounds are doubles, of a range in which a field has two decimals:
    !> one value in twelve would be rounded into the next stratum.
    subroutine narrow_strata()
        integer, parameter :: number = 16384
        character(:), allocatable :: said
        real(dp) :: value(1)
        integer :: met(-number:0), i, crossing

        call make('SWEEP,LATIN,16384|LINE,A,SIDE,-5.|VARY,FROM,A,-1024.,0.|', said)
        met = 0
        crossing = 0
        do i = 1, number
            value = values_of(plan, i)
            associate (stratum => floor(16.0_dp*value(1)))
                met(stratum) = met(stratum) + 1
                if (stratum /= floor(plan%share(i, 1)*16384.0_dp) - number) crossing = crossing + 1
            end associate
        end do
        call tap%same(said, '', 'a hypercube of narrow strata is made')
        call tap%ok(all(met(-number:-1) == 1) .and. met(0) == 0, &
            'each stratum is met once by the figures that fit a field')
        call tap%ok(crossing == 0, 'by the variant that should meet it')
    end subroutine narrow_strata

    !> How far two variables go together.
    pure real(dp) function cor(x, y)
        real(dp), intent(in) :: x(:), y(:)
        real(dp) :: u(size(x)), v(size(x))
        u = x - sum(x)/real(size(x), dp)
        v = y - sum(y)/real(size(y), dp)
        cor = dot_product(u, v)/sqrt(dot_product(u, u)*dot_product(v, v))
    end function cor

    subroutine lists()
        character(:), allocatable :: said
        call make('SWEEP,LIST|LINE,A,SIDE,5.|VARY,FROM,A,1.,2.,3|LINE,B,SIDE,1.|'// &
            'VARY,LIST,FROM,B,4.,5.,7.|', said)
        call tap%same(said, '', 'a list is made')
        call tap%ok(plan%count == 3 .and. all(abs(values_of(plan, 2) - [1.5_dp, &
            5.0_dp]) <= 0.0_dp), &
            'the second variant has the second values')
        call make('SWEEP,LIST|'//a//b, said)
        call tap%has(said, 'B has 2 values, A has 3; with SWEEP LIST all have as many', &
            'lists of different length')
        call make('SWEEP,LIST|'//a//'LINE,B,SIDE,5.|VARY,LIST,FROM,B,10.|', said)
        call tap%has(said, 'B has 1 value, A has 3', 'a list of one')
    end subroutine lists

    subroutine refusals()
        character(:), allocatable :: said
        call make('', said)
        call tap%has(said, 'no VARY card', 'nothing varies')
        call make('LINE,A,SIDE,5.|VARY,FROM,A,1.,2.|', said)
        call tap%has(said, 'COUNT is missing', 'a range without COUNT')
        call make('LINE,A,SIDE,5.|VARY,FROM,A,1.,2.,1000|'// &
            'LINE,B,SIDE,5.|VARY,FROM,B,1.,2.,1001|', said)
        call tap%has(said, '10:19-22 error: the grid has 1000 x 1001 = 1001000 variants, more '// &
            'than 1000000; smaller COUNTs, or SWEEP LATIN', 'a grid too large, with the '// &
            'card that makes it so')
        call make(a//'LINE,B,SIDE,5.|VARY,FROM,B,1.,2.,900000|LINE,C,SIDE,5.|'// &
            'VARY,FROM,C,1.,2.,700000|LINE,D,SIDE,5.|VARY,FROM,D,1.,2.,800000|', said)
        call tap%has(said, '10:19-24 error: the grid has 3 x 900000 x 700000 x 800000 '// &
            'variants, more', 'a grid beyond counting, with the first card that makes it too large')
        call make('LINE,A,SIDE,5.|VARY,FROM,A,1.,2.,1000|'// &
            'LINE,B,SIDE,5.|VARY,FROM,B,1.,2.,1000|', said)
        call tap%ok(plan%count == 1000000, 'the largest grid')
    end subroutine refusals

end program test_plan
