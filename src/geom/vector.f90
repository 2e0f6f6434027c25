!> Products of vectors, and how a point is written in a sentence.
module geom_vector
    use base_kinds, only: dp, i64
    use base_text, only: compact, compact_length
    use geom_twofold, only: exact_product, operator(*), operator(+), operator(-), twofold_type
    implicit none (type, external)
    private

    public :: cross, dot, image, at_text

    !> The area of the parallelogram of two vectors, positive where the second is to the left.
    interface cross
        module procedure cross_real, cross_twofold, cross_mixed
    end interface cross

    !> The inner product of two vectors.
    interface dot
        module procedure dot_twofold, dot_mixed
    end interface dot

contains

    !> A matrix times a vector, column after column. (`matmul` sums in an order of each build.)
    pure function image(matrix, v)
        real(dp), intent(in) :: matrix(:, :)    !! any
        real(dp), intent(in) :: v(:)            !! as many numbers as it has columns
        real(dp) :: image(size(matrix, 1))
        integer :: j
        image = 0.0_dp
        do j = 1, size(v)
            image = image + v(j)*matrix(:, j)
        end do
    end function image

    !> `u x v`, the two products exact and their difference rounded once.
    pure real(dp) function cross_real(u, v) result(area)
        real(dp), intent(in) :: u(2) !! first vector
        real(dp), intent(in) :: v(2) !! second vector
        type(twofold_type) :: exact
        exact = exact_product(u(1), v(2)) - exact_product(u(2), v(1))
        area = exact%high
    end function cross_real

    !> `u x v` in twofold numbers.
    pure type(twofold_type) function cross_twofold(u, v) result(area)
        type(twofold_type), intent(in) :: u(2) !! first vector
        type(twofold_type), intent(in) :: v(2) !! second vector
        area = u(1)*v(2) - u(2)*v(1)
    end function cross_twofold

    !> `u x v` of a twofold vector and one of doubles.
    pure type(twofold_type) function cross_mixed(u, v) result(area)
        type(twofold_type), intent(in) :: u(2) !! first vector
        real(dp), intent(in) :: v(2)           !! second vector
        area = v(2)*u(1) - v(1)*u(2)
    end function cross_mixed

    !> `u . v` in twofold numbers.
    pure type(twofold_type) function dot_twofold(u, v) result(inner)
        type(twofold_type), intent(in) :: u(2) !! first vector
        type(twofold_type), intent(in) :: v(2) !! second vector
        inner = u(1)*v(1) + u(2)*v(2)
    end function dot_twofold

    !> `u . v` of a twofold vector and one of doubles.
    pure type(twofold_type) function dot_mixed(u, v) result(inner)
        type(twofold_type), intent(in) :: u(2) !! first vector
        real(dp), intent(in) :: v(2)           !! second vector
        inner = v(1)*u(1) + v(2)*u(2)
    end function dot_mixed

    !> A point for a sentence: `(12.5, -3.)`.
    pure function at_text(point) result(text)
        real(dp), intent(in) :: point(2) !! x and y
        character(compact_length(point(1)) + compact_length(point(2)) + 4_i64) :: text
        text = '('//compact(point(1))//', '//compact(point(2))//')'
    end function at_text

end module geom_vector
