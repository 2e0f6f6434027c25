!> Fields of the data cards under a LINE: the ways a conic is given in the trade.
module deck_body_data_fields
    use deck_body_layout, only: body_field_type, card => body_card, form, need
    implicit none (type, external)
    private

    !> The data cards, each with its points in order from the first to the last.
    type(body_field_type), parameter, public :: data_fields(78) = [ &
        body_field_type(card%conic, 1, 'X1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%conic, 2, 'Y1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%conic, 3, 'S1', form%number, need%always, 'dy/dx', &
        'slope at the first point; vertical from a size of 999.99 on'), &
        body_field_type(card%conic, 4, 'X2', form%number, need%unmatched, 'deck unit', &
        'shoulder point, on the curve between the ends; blank with MATCH'), &
        body_field_type(card%conic, 5, 'Y2', form%number, need%unmatched, 'deck unit', &
        'shoulder point; blank with MATCH'), &
        body_field_type(card%conic, 6, 'X3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%conic, 7, 'Y3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%conic, 8, 'S3', form%number, need%always, 'dy/dx', &
        'slope at the last point; vertical from a size of 999.99 on'), &
        body_field_type(card%rho, 2, 'X1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%rho, 3, 'Y1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%rho, 4, 'S1', form%number, need%always, 'dy/dx', &
        'slope at the first point; vertical from a size of 999.99 on'), &
        body_field_type(card%rho, 5, 'X3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%rho, 6, 'Y3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%rho, 7, 'S3', form%number, need%always, 'dy/dx', &
        'slope at the last point; vertical from a size of 999.99 on'), &
        body_field_type(card%rho, 8, 'RHO', form%number, need%unmatched, 'none', &
        'rho, above 0 and below 1; .5 is a parabola; blank with MATCH'), &
        body_field_type(card%tangent, 2, 'X1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%tangent, 3, 'Y1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%tangent, 4, 'XT', form%number, need%always, 'deck unit', &
        'intersection of the end tangents'), &
        body_field_type(card%tangent, 5, 'YT', form%number, need%always, 'deck unit', &
        'intersection of the end tangents'), &
        body_field_type(card%tangent, 6, 'X2', form%number, need%unmatched, 'deck unit', &
        'shoulder point, on the curve between the ends; blank with MATCH'), &
        body_field_type(card%tangent, 7, 'Y2', form%number, need%unmatched, 'deck unit', &
        'shoulder point; blank with MATCH'), &
        body_field_type(card%tangent, 8, 'X3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%tangent, 9, 'Y3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%tangent_rho, 2, 'X1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%tangent_rho, 3, 'Y1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%tangent_rho, 4, 'XT', form%number, need%always, 'deck unit', &
        'intersection of the end tangents'), &
        body_field_type(card%tangent_rho, 5, 'YT', form%number, need%always, 'deck unit', &
        'intersection of the end tangents'), &
        body_field_type(card%tangent_rho, 6, 'X3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%tangent_rho, 7, 'Y3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%tangent_rho, 8, 'RHO', form%number, need%unmatched, 'none', &
        'rho, above 0 and below 1; .5 is a parabola; blank with MATCH'), &
        body_field_type(card%four_points, 2, 'X1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%four_points, 3, 'Y1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%four_points, 4, 'S', form%number, need%always, 'dy/dx', &
        'slope at the first point; with LAST, at the last'), &
        body_field_type(card%four_points, 5, 'XA', form%number, need%always, 'deck unit', &
        'point on the curve'), &
        body_field_type(card%four_points, 6, 'YA', form%number, need%always, 'deck unit', &
        'point on the curve'), &
        body_field_type(card%four_points, 7, 'XB', form%number, need%always, 'deck unit', &
        'point on the curve'), &
        body_field_type(card%four_points, 8, 'YB', form%number, need%always, 'deck unit', &
        'point on the curve'), &
        body_field_type(card%four_points, 9, 'X3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%four_points, 10, 'Y3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%five_points, 2, 'X1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%five_points, 3, 'Y1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%five_points, 4, 'XA', form%number, need%always, 'deck unit', &
        'point on the curve'), &
        body_field_type(card%five_points, 5, 'YA', form%number, need%always, 'deck unit', &
        'point on the curve'), &
        body_field_type(card%five_points, 6, 'XB', form%number, need%always, 'deck unit', &
        'point on the curve'), &
        body_field_type(card%five_points, 7, 'YB', form%number, need%always, 'deck unit', &
        'point on the curve'), &
        body_field_type(card%five_points, 8, 'XC', form%number, need%always, 'deck unit', &
        'point on the curve'), &
        body_field_type(card%five_points, 9, 'YC', form%number, need%always, 'deck unit', &
        'point on the curve'), &
        body_field_type(card%five_points, 10, 'X3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%five_points, 11, 'Y3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%straight, 2, 'X1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%straight, 3, 'Y1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%straight, 4, 'X3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%straight, 5, 'Y3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%circle, 2, 'X1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%circle, 3, 'Y1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%circle, 4, 'X2', form%number, need%always, 'deck unit', &
        'point on the arc'), &
        body_field_type(card%circle, 5, 'Y2', form%number, need%always, 'deck unit', &
        'point on the arc'), &
        body_field_type(card%circle, 6, 'X3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%circle, 7, 'Y3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%radius, 2, 'X1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%radius, 3, 'Y1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%radius, 4, 'X3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%radius, 5, 'Y3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%radius, 6, 'R', form%number, need%always, 'deck unit', &
        'radius, positive where the arc curves left from point 1 to 3'), &
        body_field_type(card%cyclic, 2, 'X1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%cyclic, 3, 'Y1', form%number, need%always, 'deck unit', &
        'first point'), &
        body_field_type(card%cyclic, 4, 'XA', form%number, need%always, 'deck unit', &
        'pole on the tangent at the first point'), &
        body_field_type(card%cyclic, 5, 'YA', form%number, need%always, 'deck unit', &
        'pole on the tangent at the first point'), &
        body_field_type(card%cyclic, 6, 'XB', form%number, need%always, 'deck unit', &
        'pole on the tangent at the last point'), &
        body_field_type(card%cyclic, 7, 'YB', form%number, need%always, 'deck unit', &
        'pole on the tangent at the last point'), &
        body_field_type(card%cyclic, 8, 'X3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%cyclic, 9, 'Y3', form%number, need%always, 'deck unit', &
        'last point'), &
        body_field_type(card%cyclic, 10, 'ALPHA', form%number, need%always, 'degrees', &
        'above 0, to 180; a circular arc of that turn is exact'), &
        body_field_type(card%blend, 2, 'ALPHA', form%number, need%optional, 'degrees', &
        'of the C-Bezier curve: above 0, to 90; blank: 60.'), &
        body_field_type(card%blend, 3, 'THETA', form%number, need%optional, 'degrees', &
        'circle to circle: between its sides, to 80; blank: the evenest'), &
        body_field_type(card%point, 1, 'X', form%number, need%always, 'deck unit', &
        'of a point or pole; under FAIRED the BL'), &
        body_field_type(card%point, 2, 'Y', form%number, need%always, 'deck unit', &
        'of a point or pole; under FAIRED the WL'), &
        body_field_type(card%point, 3, 'END', form%either, need%optional, 'dy/dx', &
        'end of a SPLINE: slope, FREE, PARABOLA; a point faired: weight')]

end module deck_body_data_fields
