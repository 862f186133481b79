package org.maestro.console;

import com.fasterxml.jackson.databind.JsonNode;
import io.javalin.http.Context;
import java.util.concurrent.CompletionException;
import org.maestro.console.access.DeniedException;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.questions.RefusalException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Answers that say why there is no other: one sentence, and whose matter it is. */
final class Problems {
  static final int BAD_INPUT = 400;
  static final int UNKNOWN = 401;
  static final int FORBIDDEN = 403;
  static final int NOT_FOUND = 404;
  static final int NOT_ALLOWED = 405;
  static final int NOT_ACCEPTABLE = 406;
  static final int TOO_OFTEN = 429;
  static final int OUTSIDE = 503;

  private static final Logger LOG = LoggerFactory.getLogger(Problems.class);

  private Problems() {}

  static void answer(Context context, int status, String sentence) {
    JsonNode document =
        JsonMembers.empty()
            .text("problem", sentence)
            .text("kind", status < 500 ? "bad-input" : "outside")
            .node();
    context.status(status).contentType("application/json").result(document.toString());
  }

  /** What went wrong, for people. */
  static String sentence(Throwable failure) {
    return String.valueOf(cause(failure).getMessage());
  }

  private static Throwable cause(Throwable failure) {
    return failure instanceof CompletionException && failure.getCause() != null
        ? failure.getCause()
        : failure;
  }

  /** Why somebody is not let in. */
  static void answer(Context context, DeniedException denial) {
    int status =
        switch (denial.reason()) {
          case UNKNOWN -> UNKNOWN;
          case FORBIDDEN -> FORBIDDEN;
          case TOO_OFTEN -> TOO_OFTEN;
        };
    answer(context, status, String.valueOf(denial.getMessage()));
    if (status == UNKNOWN) {
      // Of a scheme that browsers know they would ask for a password themselves.
      context.header("WWW-Authenticate", "Session");
    }
    denial
        .again()
        .ifPresent(
            wait -> context.header("Retry-After", String.valueOf(Math.max(1, wait.toSeconds()))));
  }

  /** What went wrong while it was answered. */
  static void answer(Context context, Throwable failure) {
    Throwable cause = cause(failure);
    if (cause instanceof RefusalException refusal) {
      int status =
          switch (refusal.kind()) {
            case BAD_INPUT -> BAD_INPUT;
            case NOT_THERE -> NOT_FOUND;
            case OUTSIDE -> OUTSIDE;
          };
      answer(context, status, String.valueOf(refusal.getMessage()));
    } else if (cause instanceof DeniedException denial) {
      answer(context, denial);
    } else {
      LOG.error("A request could not be answered: {} {}", context.method(), context.path(), cause);
      answer(context, OUTSIDE, "The console failed; the platform's log says why.");
    }
  }
}
