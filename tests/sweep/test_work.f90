!> Work is shared out whole: every variant that is pending is kept once, by any number of threads;
!> what a keeper fails with ends the work.
program test_work
    use base_error, only: error_type
    use support_ellipsoid, only: ellipsoid_study, ellipsoid_text
    use support_keeper, only: list_keeper_type
    use support_tap, only: tap_type
    use sweep_ranks, only: team_type
    use sweep_record, only: record_type, row_of_record
    use sweep_study, only: study_type
    use sweep_variant, only: compute_variant
    use sweep_work, only: lead_work
    implicit none (type, external)

    type(tap_type) :: tap
    type(study_type) :: study
    type(list_keeper_type) :: keeper
    type(record_type) :: record
    type(error_type), allocatable :: error
    integer :: i, unlike

    study = ellipsoid_study(ellipsoid_text('-1.,3.,9', '1.,3.,7', &
        'OBJECT,VOLUME,MAX|LIMIT,WIDTH,1.,,9.,0.'), tap)
    call lead_work(study, team_type(), [(i, i = 2, 63)], keeper, error)
    call tap%ok(.not. allocated(error), 'the work is done')
    call tap%ok(size(keeper%row) == 62, 'each variant that is pending is kept')
    unlike = 0
    do i = 2, 63
        call compute_variant(study, i, record)
        if (count_of(row_of_record(record, .false.)) /= 1) unlike = unlike + 1
    end do
    call tap%ok(unlike == 0, 'once, and as it is computed alone, also where it can''t be built')
    deallocate (keeper%row)
    call lead_work(study, team_type(), [integer ::], keeper, error)
    call tap%ok(.not. allocated(keeper%row), 'no variants, no work')
    keeper%most = 5
    call lead_work(study, team_type(), [(i, i = 1, 63)], keeper, error)
    call tap%ok(allocated(error), 'an error of the keeper is passed on')
    call tap%ok(size(keeper%row) == 5, 'and ends the work')
    call tap%finish()

contains

    !> How often a row was kept.
    integer function count_of(row)
        character(*), intent(in) :: row
        integer :: k
        count_of = 0
        do k = 1, size(keeper%row)
            if (keeper%row(k)%text == row) count_of = count_of + 1
        end do
    end function count_of

end program test_work
