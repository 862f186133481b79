package org.maestro.platform.jade;

import jade.core.Runtime;
import jade.wrapper.AgentContainer;
import java.time.Duration;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;

/**
 * The part of JADE that there is once for a whole process, such as the threads that deliver
 * messages: it begins with the first container, and ends with the last in a thread of JADE's own. A
 * container that began before that thread was through got the old ones, and its messages were never
 * delivered. JADE also counts its containers without guarding the count, so they begin and end one
 * at a time.
 */
final class SharedJade {
  private static final Duration LONGEST_END = Duration.ofSeconds(1);

  private final Set<AgentContainer> live = Collections.newSetFromMap(new IdentityHashMap<>());
  private Optional<CompletableFuture<Thread>> end = Optional.empty();

  /** Returns the container; empty when JADE could not begin it. */
  synchronized Optional<AgentContainer> begin(Supplier<Optional<AgentContainer>> beginning) {
    live.removeIf(container -> !container.isJoined());
    if (live.isEmpty()) {
      awaitEnd();
      CompletableFuture<Thread> next = new CompletableFuture<>();
      // Of these JADE runs first what was given last: its own are given after this one.
      Runtime.instance().invokeOnTermination(() -> next.complete(Thread.currentThread()));
      end = Optional.of(next);
    }
    Optional<AgentContainer> begun = beginning.get();
    begun.ifPresent(live::add);
    return begun;
  }

  synchronized void end(Runnable ending) {
    ending.run();
  }

  /** Not for ever: somebody else in this process may have a container too, so that nothing ends. */
  private void awaitEnd() {
    if (end.isEmpty()) {
      return;
    }
    try {
      end.get().get(LONGEST_END.toMillis(), TimeUnit.MILLISECONDS).join(LONGEST_END.toMillis());
    } catch (TimeoutException goesOn) {
      end = Optional.empty();
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
