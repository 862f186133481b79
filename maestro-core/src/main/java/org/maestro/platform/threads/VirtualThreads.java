package org.maestro.platform.threads;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.Optional;

/** Virtual threads for a program that has to run without them too. Thread-safe. */
final class VirtualThreads {
  /**
   * The first Java in which a virtual thread that waits in a monitor, as idle agents do, lets go of
   * the system's thread that carries it. Before, 256 idle agents stop all others.
   */
  private static final int FIRST_JAVA = 24;

  private static final Optional<MethodHandle> MAKER = maker();

  private VirtualThreads() {}

  static boolean areThere() {
    return MAKER.isPresent();
  }

  /** One that is not started yet. */
  static Thread make(String name, Runnable work) {
    MethodHandle maker =
        MAKER.orElseThrow(() -> new IllegalStateException("This Java has no virtual threads."));
    try {
      Thread thread = (Thread) maker.invoke(work);
      thread.setName(name);
      return thread;
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException("Java could not make a virtual thread.", e);
    }
  }

  /** What {@code Thread.ofVirtual().unstarted(work)} is. */
  private static Optional<MethodHandle> maker() {
    if (Runtime.version().feature() < FIRST_JAVA) {
      return Optional.empty();
    }
    try {
      MethodHandles.Lookup lookup = MethodHandles.publicLookup();
      Class<?> builder = Class.forName("java.lang.Thread$Builder");
      Class<?> ofVirtual = Class.forName("java.lang.Thread$Builder$OfVirtual");
      MethodHandle begin =
          lookup.findStatic(Thread.class, "ofVirtual", MethodType.methodType(ofVirtual));
      MethodHandle unstarted =
          lookup.findVirtual(
              builder, "unstarted", MethodType.methodType(Thread.class, Runnable.class));
      return Optional.of(
          MethodHandles.foldArguments(
              unstarted.asType(MethodType.methodType(Thread.class, ofVirtual, Runnable.class)),
              begin));
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(
          "Java %d should have virtual threads.".formatted(FIRST_JAVA), e);
    }
  }
}
