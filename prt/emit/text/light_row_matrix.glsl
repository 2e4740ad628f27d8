
void light_row(int row, out float numbers[NUMBERS]) {
    for (int i = 0; i < NUMBERS; ++i) numbers[i] = 0.0;
    add_indirect(row, numbers);
}
