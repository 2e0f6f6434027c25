!> Results that belong together, such as a drawing and its receipt: all get their names, or none.
!>
!> They are written one after the other under other names, and renamed at the end together.
module app_file_set
    use app_files, only: result_file_type
    use base_error, only: error_type
    use base_output, only: output_type
    implicit none (type, external)
    private

    public :: file_set_type

    !> Results on their way. Only the last one is open.
    type :: file_set_type
        private
        type(result_file_type), allocatable :: files(:)
    contains
        procedure :: begin => begin_file
        procedure :: finish => finish_file
        procedure :: is_device
        procedure :: publish
        procedure :: abandon
    end type file_set_type

contains

    !> Begins the next result; the one before must be finished.
    !>
    !> Fails with `cause%file_trouble`; the set must then be given up.
    subroutine begin_file(set, name, out, error)
        class(file_set_type), intent(inout) :: set          !! the set
        character(*), intent(in) :: name                    !! as the user gave it
        type(output_type), intent(inout) :: out             !! new; what is put there goes to it
        type(error_type), allocatable, intent(out) :: error !! see above
        type(result_file_type), allocatable :: grown(:)
        integer :: count

        count = 0
        if (allocated(set%files)) count = size(set%files)
        allocate (grown(count + 1))
        if (count > 0) grown(:count) = set%files
        call move_alloc(grown, set%files)
        call set%files(count + 1)%begin(name, out, error)
    end subroutine begin_file

    !> Hands over all of the result begun last.
    !>
    !> Fails with `cause%file_trouble`; the set must then be given up.
    subroutine finish_file(set, out, error)
        class(file_set_type), intent(inout) :: set          !! the set
        type(output_type), intent(inout) :: out             !! as `begin` had it
        type(error_type), allocatable, intent(out) :: error !! see above
        call set%files(size(set%files))%finish(out, error)
    end subroutine finish_file

    !> True where the result begun last is a device, a FIFO or standard output.
    logical function is_device(set)
        class(file_set_type), intent(in) :: set !! the set
        is_device = set%files(size(set%files))%is_device()
    end function is_device

    !> Gives all results, which are finished, their names.
    !>
    !> Fails with `cause%file_trouble` where one can't be renamed; none has its name then, and what
    !> had the names before has them again.
    subroutine publish(set, error)
        class(file_set_type), intent(inout) :: set          !! the set
        type(error_type), allocatable, intent(out) :: error !! see above
        integer :: i, published

        published = 0
        if (size(set%files) > 1) then
            do i = 1, size(set%files)
                call set%files(i)%keep_former()
            end do
        end if
        do i = 1, size(set%files)
            call set%files(i)%publish(error)
            if (allocated(error)) exit
            published = i
        end do
        if (allocated(error)) then
            do i = 1, published
                call set%files(i)%take_back()
            end do
            call set%abandon()
        end if
        do i = 1, size(set%files)
            call set%files(i)%drop_former()
        end do
    end subroutine publish

    !> Gives all results up that have not got their names.
    subroutine abandon(set)
        class(file_set_type), intent(inout) :: set !! the set
        integer :: i
        if (.not. allocated(set%files)) return
        do i = 1, size(set%files)
            call set%files(i)%abandon()
        end do
    end subroutine abandon

end module app_file_set
