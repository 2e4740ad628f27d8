
void light_row(int row, out float numbers[NUMBERS]) {
    vec3 sums = row_sums(row);
    for (int c = 0; c < 3; ++c) numbers[c] = sums[c];
}
