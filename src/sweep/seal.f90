!> The seal of a row in a journal: the first eight figures of its SHA-256, behind it. A row that was
!> damaged on the disk, by hand or by a program does not fit it.
!>
!>     12,-7.5,.45,8013.2,2911.7,ok,,,17fa99f1
module sweep_seal
    use base_sha256, only: sha256_type
    implicit none (type, external)
    private

    public :: sealed, unseal

    !> Figures of a seal.
    integer, parameter :: seal_length = 8

contains

    !> A row with its seal.
    pure function sealed(row) result(line)
        character(*), intent(in) :: row !! of a variant
        character(len(row) + 1 + seal_length) :: line
        type(sha256_type) :: sum
        character(64) :: figures

        call sum%take(row)
        figures = sum%hex()
        line = row//','//figures(:seal_length)
    end function sealed

    !> Takes the seal off a row.
    pure subroutine unseal(line, row, fits)
        character(*), intent(in) :: line                !! a row with its seal, or anything
        character(:), allocatable, intent(out) :: row   !! what stands before the seal
        logical, intent(out) :: fits                    !! it is the row that was sealed

        row = line(:max(0, len(line) - seal_length - 1))
        fits = sealed(row) == line
    end subroutine unseal

end module sweep_seal
