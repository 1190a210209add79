// The program `hottel`.
int main() { return 2; }
