
void light_row(int row, out float numbers[NUMBERS]) { direct(row, numbers); }
