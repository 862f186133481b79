package org.maestro.launch;

import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.maestro.console.client.UnreachableConsoleException;
import org.maestro.console.questions.AclQuestions;
import org.maestro.console.questions.Questions;
import org.maestro.console.questions.RefusalException;
import org.maestro.platform.JoinedContainer;

/**
 * A platform to which questions are put: by its console, which answers at once, or, where there is
 * none, by an agent of this process. Any thread may ask; one after the other is answered.
 */
final class AskedPlatform implements AutoCloseable {
  private final Optional<Questions> console;
  private final Supplier<JoinedContainer> join;
  private @Nullable JoinedContainer joined;

  /**
   * @param console of the platform, if it is known to have one
   * @param join joins the platform
   */
  AskedPlatform(Optional<Questions> console, Supplier<JoinedContainer> join) {
    this.console = console;
    this.join = join;
  }

  /**
   * The answer to a question.
   *
   * @throws CommandException when it is refused, or nobody answers
   */
  synchronized <T> T answer(Function<Questions, CompletableFuture<T>> question) {
    if (console.isPresent()) {
      try {
        return answer(question, console.get());
      } catch (UnreachableConsoleException e) {
        // The platform may be there all the same.
        return answer(question, byAgent());
      }
    }
    return answer(question, byAgent());
  }

  private static <T> T answer(Function<Questions, CompletableFuture<T>> question, Questions asked) {
    try {
      return question.apply(asked).join();
    } catch (CompletionException e) {
      Throwable cause = Objects.requireNonNullElse(e.getCause(), e);
      if (cause instanceof RefusalException refusal) {
        throw CommandException.of(refusal);
      }
      throw CommandException.outside("The platform does not answer.", cause);
    }
  }

  private Questions byAgent() {
    if (joined == null) {
      joined = join.get();
    }
    String own = joined.name();
    return new AclQuestions(joined.desk(), container -> !container.equals(own));
  }

  @Override
  public void close() {
    if (joined != null) {
      joined.close();
    }
  }
}
