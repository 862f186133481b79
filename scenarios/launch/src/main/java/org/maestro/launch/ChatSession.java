package org.maestro.launch;

import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;

/**
 * A conversation from its first line to its end: lines are read on a thread of their own, so that
 * what comes meanwhile is shown as it comes.
 */
final class ChatSession {
  private static final long LOOK_EVERY_MILLIS = 200;
  private static final String END = "exit";

  private final Keyboard keyboard;
  private final Conversing conversation;
  private final BlockingQueue<Optional<String>> written = new LinkedBlockingQueue<>();
  private final Semaphore mayWrite = new Semaphore(1);

  ChatSession(Keyboard keyboard, Conversing conversation) {
    this.keyboard = keyboard;
    this.conversation = conversation;
  }

  /**
   * Converses until the person ends it, and lines that came in without her are answered.
   *
   * @return what the shell is told
   */
  int converse() throws InterruptedException {
    conversation.begin();
    Thread writing = new Thread(this::write, "chat-keyboard");
    writing.setDaemon(true);
    writing.start();
    boolean isOver = false;
    while (!isOver || !keyboard.isWrittenByHand() && !conversation.isAnswered()) {
      Optional<String> line =
          Optional.ofNullable(written.poll(LOOK_EVERY_MILLIS, TimeUnit.MILLISECONDS))
              .map(one -> one.map(String::strip).orElse(END));
      try {
        line.filter(text -> !text.isEmpty() && !text.equals(END)).ifPresent(conversation::say);
        conversation.look();
      } catch (CommandException e) {
        if (e.exitCode() == ExitCode.OUTSIDE) {
          keyboard.print("The platform does not answer any more; the conversation is over.");
          return ExitCode.OUTSIDE;
        }
        keyboard.print(String.valueOf(e.getMessage()));
      }
      isOver = isOver || line.filter(END::equals).isPresent();
      if (mayWrite.availablePermits() == 0 && conversation.isAnswered()) {
        mayWrite.release();
      }
    }
    return ExitCode.DONE;
  }

  /** A line each, the next one when the last is answered, where nobody looks on. */
  private void write() {
    Optional<String> line = Optional.of("");
    while (line.isPresent()) {
      if (!keyboard.isWrittenByHand()) {
        mayWrite.acquireUninterruptibly();
      }
      line = keyboard.line();
      written.add(line);
    }
  }
}
