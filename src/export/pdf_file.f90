!> The objects of a PDF file, numbered and counted byte by byte for its table of references.
!>
!> Source: PDF Reference, 3rd ed., Adobe Portable Document Format 1.4, section 3.4.
module export_pdf_file
    use base_kinds, only: i64
    use base_output, only: output_type
    use base_text, only: row_of, to_text
    use export_pattern_letters, only: codes_of, win_ansi
    implicit none (type, external)
    private

    public :: pdf_file_type, pdf_text

    !> What has been written of a file.
    type :: pdf_file_type
        integer(i64) :: bytes = 0                   !! of the file so far
        integer(i64), allocatable :: offset(:)      !! of each object; -1: not written yet
    contains
        procedure :: begin
        procedure :: put
        procedure :: object
        procedure :: stream
        procedure :: finish
    end type pdf_file_type

contains

    !> Begins a file. The bytes above 127 tell mail and copying programs that it is no text.
    subroutine begin(file, objects, out)
        class(pdf_file_type), intent(inout) :: file     !! the file
        integer, intent(in) :: objects                  !! how many it will have
        type(output_type), intent(inout) :: out         !! where it goes

        allocate (file%offset(objects))
        file%offset = -1_i64
        call file%put('%PDF-1.4', out)
        call file%put('%'//char(226)//char(227)//char(207)//char(211), out)
    end subroutine begin

    !> Puts a line.
    subroutine put(file, text, out)
        class(pdf_file_type), intent(inout) :: file     !! counts it
        character(*), intent(in) :: text                !! any bytes
        type(output_type), intent(inout) :: out         !! where it goes
        call out%line(text)
        file%bytes = file%bytes + len(text, i64) + 1_i64
    end subroutine put

    !> Writes an object.
    subroutine object(file, number, text, out)
        class(pdf_file_type), intent(inout) :: file     !! gets it
        integer, intent(in) :: number                   !! of the object, from 1
        character(*), intent(in) :: text                !! what it is
        type(output_type), intent(inout) :: out         !! where it goes

        file%offset(number) = file%bytes
        call file%put(to_text(number)//' 0 obj', out)
        call file%put(text, out)
        call file%put('endobj', out)
    end subroutine object

    !> Writes an object with a stream.
    subroutine stream(file, number, text, out)
        class(pdf_file_type), intent(inout) :: file     !! gets it
        integer, intent(in) :: number                   !! of the object, from 1
        character(*), intent(in) :: text                !! the stream
        type(output_type), intent(inout) :: out         !! where it goes
        call file%object(number, '<< /Length '//to_text(len(text, i64))//' >>'//new_line('a')// &
            'stream'//new_line('a')//text//new_line('a')//'endstream', out)
    end subroutine stream

    !> Writes the table of references, entries of 20 bytes, and the end. Every object is written.
    subroutine finish(file, root, info, out)
        class(pdf_file_type), intent(inout) :: file     !! the file
        integer, intent(in) :: root                     !! number of the catalogue
        integer, intent(in) :: info                     !! number of the information dictionary
        type(output_type), intent(inout) :: out         !! where it goes
        integer(i64) :: start
        integer :: i

        start = file%bytes
        call file%put('xref', out)
        call file%put('0 '//to_text(size(file%offset) + 1), out)
        call file%put('0000000000 65535 f ', out)
        do i = 1, size(file%offset)
            call file%put(ten_figures(file%offset(i))//' 00000 n ', out)
        end do
        call file%put('trailer', out)
        call file%put('<< /Size '//to_text(size(file%offset) + 1)//' /Root '//to_text(root)// &
            ' 0 R /Info '//to_text(info)//' 0 R >>', out)
        call file%put('startxref', out)
        call file%put(to_text(start), out)
        call file%put('%%EOF', out)
    end subroutine finish

    !> A number in ten figures.
    pure function ten_figures(number) result(text)
        integer(i64), intent(in) :: number !! 0 to 9999999999
        character(:), allocatable :: text
        text = to_text(number)
        text = row_of('0', 10 - len(text))//text
    end function ten_figures

    !> Words as a string of a page, in parentheses; characters that the type has not are `?`.
    pure function pdf_text(text) result(string)
        character(*), intent(in) :: text !! any bytes
        character(:), allocatable :: string
        integer, allocatable :: codes(:)
        character :: byte
        integer :: i

        allocate (codes(0))
        codes = codes_of(text)
        string = '('
        do i = 1, size(codes)
            byte = win_ansi(codes(i))
            if (byte == '(' .or. byte == ')' .or. byte == '\') string = string//'\'
            string = string//byte
        end do
        string = string//')'
    end function pdf_text

end module export_pdf_file
