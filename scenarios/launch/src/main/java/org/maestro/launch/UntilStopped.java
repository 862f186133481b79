package org.maestro.launch;

import java.io.PrintWriter;
import java.util.concurrent.CountDownLatch;

/** The wait until the process is stopped, common to the commands that stay. */
final class UntilStopped {

  private UntilStopped() {}

  /**
   * Says what runs, and waits until the process is stopped.
   *
   * @param announcement its last words say how to stop
   * @param end done when it is stopped
   */
  static void run(PrintWriter out, String announcement, Runnable end) throws InterruptedException {
    Runtime.getRuntime().addShutdownHook(new Thread(end, "shutdown"));
    announcement.concat(" Stop with Ctrl-C.").lines().forEach(out::println);
    out.flush();
    new CountDownLatch(1).await();
  }
}
