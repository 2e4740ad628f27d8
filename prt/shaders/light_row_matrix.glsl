
void light_row(int row, out float numbers[NUMBERS]) { indirect(row, numbers); }
