package org.maestro.launch;

import jade.lang.acl.ACLMessage;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.AskedGoal;
import org.maestro.agents.content.GoalReport;
import org.maestro.agents.content.HeldReport;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.OtherPlatform;
import org.maestro.console.questions.AclQuestions;
import org.maestro.console.questions.RefusalException;
import org.maestro.console.questions.Reply;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.platform.JoinedContainer;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.sl.Content;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/**
 * A command that states a goal to a running platform, by an agent of this process, and follows it.
 */
abstract class StatedGoal implements Callable<Integer> {
  private static final int LOOK_AGAIN_SECONDS = 2;

  /** A platform that stands by has taken over by then, if there is one. */
  private static final Duration RETURN = Duration.ofSeconds(20);

  /** By then the agents of one that has taken over are there, also on a busy machine. */
  private static final Duration SETTLED = Duration.ofSeconds(60);

  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(10);
  private static final Duration BETWEEN_LOOKS = Duration.ofMillis(250);

  /** Nearly always it is there by then. */
  private static final Duration SOON = Duration.ofSeconds(5);

  /**
   * JADE keeps what a process knows of a platform for a second after its last container: who joins
   * before goes on with that.
   */
  private static final Duration FORGOTTEN = Duration.ofMillis(1_500);

  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Option(
      names = "--priority",
      paramLabel = "N",
      defaultValue = "0",
      description = "A whole number; a higher one goes first. Usual: ${DEFAULT-VALUE}.")
  private int priority;

  @Option(
      names = "--deadline",
      paramLabel = "SECONDS",
      description = "Simulated seconds from now by which it has to be reached; else it fails.")
  private Optional<Double> deadlineSeconds = Optional.empty();

  @Mixin private StakesOptions stakes;

  @Option(
      names = "--as",
      paramLabel = "PERSON",
      description = "The person of the home for whom it is; what she may not is not done.")
  private Optional<String> speaker = Optional.empty();

  /** The last line of a story is on its way when the goal has ended; it comes by itself. */
  private static final Duration STORY_ENDS = Duration.ofSeconds(2);

  private volatile String id = "";
  private volatile CompletableFuture<Void> told = CompletableFuture.completedFuture(null);
  private volatile boolean agreed;
  private boolean resumes;
  private long goneSince;
  private int attempts;

  @Option(
      names = "--other",
      paramLabel = "NAME@URL",
      description =
          "Ask the CCA of another platform, NAME, by an agent of this one; both run with --mtp.")
  private Optional<String> named = Optional.empty();

  private Optional<OtherPlatform> other = Optional.empty();

  @Option(names = "--json", description = "Print one JSON document instead of the story.")
  private boolean json;

  /** The goal in MAESTRO-SL; of one that was stated before, its id. */
  abstract String goal();

  abstract boolean wasStated();

  @Override
  public final Integer call() {
    other = named.map(StatedGoal::otherPlatform);
    Endpoint endpoint = platform.endpoint();
    while (true) {
      try {
        return ask(endpoint);
      } catch (PlatformGoneException e) {
        goneSince = System.nanoTime();
        awaitReturn(endpoint);
        resumes = true;
      } catch (PlatformStartException e) {
        // Who has just taken over listens a moment before its agents are there.
        if (!resumes || isGoneFor(SETTLED)) {
          throw e;
        }
        LockSupport.parkNanos((isGoneFor(SOON) ? FORGOTTEN : BETWEEN_LOOKS).toNanos());
      }
    }
  }

  private static OtherPlatform otherPlatform(String text) {
    try {
      return OtherPlatform.parse(text);
    } catch (IllegalArgumentException e) {
      throw CommandException.badInput(e);
    }
  }

  /** The platform that was asked is no more; another may have taken over. */
  private static final class PlatformGoneException extends RuntimeException {
    private static final long serialVersionUID = 1L;
  }

  private boolean isGoneFor(Duration time) {
    return System.nanoTime() - goneSince > time.toNanos();
  }

  private void awaitReturn(Endpoint endpoint) {
    while (id.isEmpty() || !platform.isStillAt(endpoint) || !endpoint.answers()) {
      if (id.isEmpty() || isGoneFor(RETURN)) {
        throw CommandException.outside(
            "The platform has ended before the goal did; if it keeps its goals (run --data), start it again, and ./maestro goal --follow %s tells how it ends."
                .formatted(id.isEmpty() ? "GOAL" : id));
      }
      LockSupport.parkNanos(BETWEEN_LOOKS.toNanos());
    }
    if (!json) {
      spec.commandLine().getOut().println("The platform was lost, and one answers there again.");
    }
  }

  private int ask(Endpoint endpoint) {
    CompletableFuture<ACLMessage> ended = new CompletableFuture<>();
    agreed = false;
    JoinedContainer container = join();
    try {
      container.whenGivenUp(() -> ended.completeExceptionally(new PlatformGoneException()));
      request(
          container,
          ACLMessage.REQUEST,
          DeskAgent.NO_END,
          reply -> {
            if (reply.getPerformative() == ACLMessage.AGREE) {
              agreed = true;
              follow(container, reply);
            } else if (reply.getPerformative() == ACLMessage.CONFIRM || DeskAgent.isEnd(reply)) {
              ended.complete(reply);
            }
          },
          request());
      ACLMessage reply = reply(ended, endpoint, container);
      if (reply.getPerformative() == ACLMessage.NOT_UNDERSTOOD
          || reply.getPerformative() == ACLMessage.REFUSE) {
        throw refusal(reply, container);
      }
      Words words = Reply.words(reply).get(0);
      if (words.string("state").isEmpty() && resumes) {
        throw new PlatformStartException(Reply.reason(Reply.words(reply)));
      }
      if (words.string("state").isEmpty()) {
        throw CommandException.outside(Reply.reason(Reply.words(reply)));
      }
      GoalEndPrinter printer = new GoalEndPrinter(goal(), json, spec.commandLine().getOut());
      if (reply.getPerformative() == ACLMessage.CONFIRM) {
        return printer.print(HeldReport.read(true, reply.getContent()));
      }
      awaitEndOfStory();
      return printer.print(GoalReport.read(reply.getContent()));
    } catch (PlatformGoneException e) {
      container.abandon();
      throw e;
    } finally {
      container.close();
    }
  }

  /**
   * JADE throws what it likes where a platform is only half there, and one that has just taken over
   * may not be found for a moment.
   */
  private JoinedContainer join() {
    attempts++;
    try {
      return platform.join(attempts);
    } catch (PlatformStartException e) {
      throw e;
    } catch (RuntimeException e) {
      if (!resumes) {
        throw e;
      }
      throw new PlatformStartException(
          "The platform that has taken over cannot be joined: " + Failures.sentence(e), e);
    }
  }

  private void request(
      JoinedContainer container,
      int performative,
      Duration timeout,
      Consumer<ACLMessage> replies,
      Content content) {
    other.ifPresentOrElse(
        platform ->
            container
                .desk()
                .request(performative, platform, AgentNames.COORDINATOR, timeout, replies, content),
        () ->
            container
                .desk()
                .request(performative, AgentNames.COORDINATOR, timeout, replies, content));
  }

  /** Nobody tells when another platform dies; it is asked now and then. */
  private void look(JoinedContainer container, CompletableFuture<ACLMessage> ended) {
    request(
        container,
        ACLMessage.QUERY_REF,
        ANSWER_WITHIN,
        answer -> {
          if (answer.getPerformative() == ACLMessage.FAILURE) {
            ended.complete(answer);
          }
        },
        Words.content("query-ref"));
  }

  private ACLMessage reply(
      CompletableFuture<ACLMessage> ended, Endpoint endpoint, JoinedContainer container) {
    long asked = System.nanoTime();
    while (true) {
      try {
        return ended.get(LOOK_AGAIN_SECONDS, TimeUnit.SECONDS);
      } catch (TimeoutException e) {
        if (!platform.isStillAt(endpoint)) {
          throw new PlatformGoneException();
        }
        if (resumes && !agreed && System.nanoTime() - asked > ANSWER_WITHIN.toNanos()) {
          // What was sent while it was just taking over may have gone to nobody.
          throw new PlatformStartException("The platform that has taken over does not answer.");
        }
        if (other.isPresent()) {
          look(container, ended);
        }
      } catch (ExecutionException e) {
        if (e.getCause() instanceof PlatformGoneException gone) {
          throw gone;
        }
        throw CommandException.outside("The goal is not followed any more.", e);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw CommandException.outside("The goal is not followed any more.", e);
      }
    }
  }

  /** Words may be unknown because the device that brings them cannot be used. */
  private RefusalException refusal(ACLMessage reply, JoinedContainer container) {
    List<Words> words = Reply.words(reply);
    RefusalException refusal = Reply.refusal(words);
    boolean isInvalid = words.stream().anyMatch(line -> line.string("invalid").isPresent());
    List<String> unusable =
        isInvalid && other.isEmpty()
            ? AgentsCommand.refused(new AclQuestions(container.desk()).agents().join())
            : List.of();
    return unusable.isEmpty()
        ? refusal
        : refusal.and(
            "What %s would bring is not known, as it is described wrongly; ./maestro agents says how."
                .formatted(String.join(", ", unusable)));
  }

  /** How it ended is said after how it came to that. */
  private void awaitEndOfStory() {
    try {
      told.get(STORY_ENDS.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException | ExecutionException e) {
      // How it ended counts more than the last lines of how it came to that.
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private Content request() {
    if (wasStated() || resumes) {
      return Words.content("await", Words.named("goal", Words.name(resumes ? id : goal())));
    }
    return new AskedGoal(goal())
        .priority(priority)
        .deadlineSeconds(deadlineSeconds)
        .speaker(speaker)
        .stakes(stakes.asked())
        .content();
  }

  private void follow(JoinedContainer container, ACLMessage agreed) {
    id = Reply.words(agreed).get(0).string("goal").orElse("");
    PrintWriter out = spec.commandLine().getOut();
    if (!json) {
      out.println(id + ": " + goal());
      Follower follower = new Follower(out);
      told = follower.told;
      Consumer<ACLMessage> lines = follower::line;
      other.ifPresentOrElse(
          platform -> container.desk().follow(platform, id, lines),
          () -> container.desk().follow(id, lines));
    }
  }

  /** Prints the lines of a story, with the first one's time as zero. */
  private static final class Follower {
    private final PrintWriter out;
    private final CompletableFuture<Void> told = new CompletableFuture<>();
    private @Nullable StoryPrinter printer;

    private Follower(PrintWriter out) {
      this.out = out;
    }

    private synchronized void line(ACLMessage message) {
      Reply.words(message).stream().map(Reply::story).forEach(this::print);
    }

    private void print(StoryEntry entry) {
      if (printer == null) {
        printer = new StoryPrinter(out, entry.at());
      }
      printer.print(entry);
      if (entry.kind() == StoryEntry.Kind.END) {
        told.complete(null);
      }
    }
  }
}
