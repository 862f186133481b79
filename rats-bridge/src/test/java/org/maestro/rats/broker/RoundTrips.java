package org.maestro.rats.broker;

import java.net.URI;
import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.TimeUnit;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/**
 * Sequential call and result round trips at QoS 1 over a broker, run by hand for {@code
 * docs/decisions/0003-broker.md}. Without an argument it starts the embedded broker, otherwise the
 * argument is the address of a running one.
 */
public final class RoundTrips {

  private static final int WARM_UP = 3_000;
  private static final int MEASURED = 10_000;

  private RoundTrips() {}

  public static void main(String[] arguments) throws InterruptedException {
    long before = System.nanoTime();
    EmbeddedBroker own = arguments.length == 0 ? EmbeddedBroker.start() : null;
    if (own != null) {
      System.out.printf("embedded broker started in %.2f s%n", (System.nanoTime() - before) / 1e9);
    }
    URI broker = own == null ? URI.create(arguments[0]) : own.uri();
    Transport member = new PahoTransport(broker, "member");
    Transport caller = new PahoTransport(broker, "caller");
    SynchronousQueue<Boolean> results = new SynchronousQueue<>();
    member.subscribe(
        "bench/call/#",
        Transport.RetainedMessages.IGNORE,
        call -> publish(member, "bench/result/caller/member", call.payload()));
    caller.subscribe(
        "bench/result/caller/#",
        Transport.RetainedMessages.IGNORE,
        result -> {
          try {
            results.put(true);
          } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
          }
        });
    open(member);
    open(caller);
    byte[] payload = new byte[300];
    run(caller, results, payload, WARM_UP);
    long start = System.nanoTime();
    long[] times = run(caller, results, payload, MEASURED);
    double seconds = (System.nanoTime() - start) / 1e9;
    Arrays.sort(times);
    System.out.printf(
        "%s: %.0f round trips/s, p50 %.3f ms, p99 %.3f ms%n",
        own == null ? broker : "embedded Artemis",
        MEASURED / seconds,
        times[MEASURED / 2] / 1e6,
        times[MEASURED * 99 / 100] / 1e6);
    caller.close();
    member.close();
    if (own != null) {
      own.close();
    }
  }

  private static long[] run(
      Transport caller, SynchronousQueue<Boolean> results, byte[] payload, int count)
      throws InterruptedException {
    long[] times = new long[count];
    for (int number = 0; number < count; number++) {
      long start = System.nanoTime();
      publish(caller, "bench/call/caller", payload);
      if (results.poll(10, TimeUnit.SECONDS) == null) {
        throw new IllegalStateException("No result within 10 s for call " + number);
      }
      times[number] = System.nanoTime() - start;
    }
    return times;
  }

  private static void publish(Transport transport, String topic, byte[] payload) {
    transport.publish(
        Publication.reliable(topic, payload, Optional.of(Duration.ofSeconds(10))),
        failure ->
            failure.ifPresent(
                cause -> {
                  throw cause;
                }));
  }

  private static void open(Transport transport) throws InterruptedException {
    CountDownLatch connected = new CountDownLatch(1);
    transport.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            connected.countDown();
          }

          @Override
          public void lost(String reason) {
            System.out.println("lost: " + reason);
          }
        });
    connected.await();
  }
}
