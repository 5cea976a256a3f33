#include "tests/oracle/lib/parallel.h"

#include <algorithm> // max
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

void parallel_rows(int rows, const std::function<void(int)> &work)
{
    std::atomic<int> next{0};
    std::exception_ptr failure;
    std::mutex lock;
    auto run = [&] {
        try {
            for (int y = next++; y < rows; y = next++)
                work(y);
        } catch (...) { // the caller's thread throws it again
            std::lock_guard<std::mutex> guard(lock);
            failure = std::current_exception();
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency());
         i++)
        threads.emplace_back(run);
    run();
    for (std::thread &thread : threads)
        thread.join();
    if (failure)
        std::rethrow_exception(failure);
}
