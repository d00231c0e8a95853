/* Sends Ctrl-C to a program, or keeps a file open, for tests on Windows.
 *
 * console stop FILE COMMAND...    runs a command in a new console, waits until a file is not empty, sends Ctrl-C
 * console hold FILE COMMAND...    keeps a file open, without shared writing and deletion, during a command
 *
 * The exit code is that of the command, or 100 to 105 if this program fails. */
#include <windows.h>
#include <wchar.h>

/* Longest duration of the command in milliseconds. */
#define PATIENCE 120000

/* Rest of a command line after a number of arguments. */
static wchar_t *rest(wchar_t *line, int skip)
{
    while (skip-- > 0) {
        int quoted = 0;
        for (; *line && (quoted || *line != L' '); line++)
            if (*line == L'"') quoted = !quoted;
        while (*line == L' ') line++;
    }
    return line;
}

static int is_filled(const wchar_t *path)
{
    WIN32_FILE_ATTRIBUTE_DATA about;
    return GetFileAttributesExW(path, GetFileExInfoStandard, &about) && (about.nFileSizeLow || about.nFileSizeHigh);
}

int wmain(int count, wchar_t **arguments)
{
    STARTUPINFOW start = { sizeof start };
    PROCESS_INFORMATION process;
    DWORD code = 105;
    int stop;

    if (count < 4) return 100;
    stop = !wcscmp(arguments[1], L"stop");
    start.dwFlags = STARTF_USESTDHANDLES;
    start.hStdInput = GetStdHandle(STD_INPUT_HANDLE);
    start.hStdOutput = GetStdHandle(STD_OUTPUT_HANDLE);
    start.hStdError = GetStdHandle(STD_ERROR_HANDLE);
    if (stop) {
        FreeConsole();
        if (!AllocConsole()) return 101;
    } else if (CreateFileW(arguments[2], GENERIC_READ, FILE_SHARE_READ, NULL, OPEN_EXISTING, 0, NULL)
               == INVALID_HANDLE_VALUE) {
        return 101;
    }
    if (!CreateProcessW(NULL, rest(GetCommandLineW(), 3), NULL, NULL, TRUE, 0, NULL, NULL, &start, &process))
        return 102;
    if (stop) {
        int wait;
        /* This program ignores Ctrl-C. The command does not inherit that. */
        SetConsoleCtrlHandler(NULL, TRUE);
        for (wait = 0; wait < PATIENCE / 50 && !is_filled(arguments[2]); wait++) Sleep(50);
        if (!GenerateConsoleCtrlEvent(CTRL_C_EVENT, 0)) return 103;
    }
    if (WaitForSingleObject(process.hProcess, PATIENCE) != WAIT_OBJECT_0) {
        TerminateProcess(process.hProcess, 104);
        return 104;
    }
    GetExitCodeProcess(process.hProcess, &code);
    return (int)code;
}
