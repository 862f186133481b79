package org.maestro.troubleshooting;

import com.sun.source.tree.AnnotationTree;
import com.sun.source.tree.BinaryTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.IdentifierTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.TreeScanner;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;

/**
 * The messages of one source file: the texts that are handed to an exception, to the log as a
 * warning or an error, or to a method that tells what is wrong; what is handed over by a method or
 * a variable of the same file counts, too.
 */
final class UnitMessages {
  /** Methods that tell what is wrong, whosever they are. */
  private static final Set<String> TELL =
      Set.of(
          "badInput",
          "outside",
          "fault",
          "warn",
          "error",
          "refuse",
          "refused",
          "rejected",
          "failed",
          "fail",
          "failure",
          "giveUp",
          "unmet",
          "lost",
          "drop",
          "unanswered",
          "complain",
          "found",
          "wrong",
          "told",
          "gone",
          "exitFailed",
          "misconduct",
          "rejectedUnremembered",
          "refusal",
          "notTaken",
          "inItsSyntax",
          "broken",
          "notTried",
          "giveBack",
          "doubt");

  /** Of these the latter is what to do about the former. */
  private static final Set<String> WITH_CURE = Set.of("fault", "warn", "told", "Fault");

  /** What is wrong is handed to these as functions. */
  private static final Set<String> TOLD = Set.of("fault", "problems");

  /** Classes that only make parts of such sentences, for others. */
  private static final Set<String> PARTS =
      Set.of(
          "coordination.story.ObstacleSentences",
          "coordination.story.SearchSentences",
          "coordination.story.WitnessSentences",
          "coordination.api.WaitsFor",
          "planning.unsolvable.MissingCondition",
          "planning.unsolvable.GoalConflict",
          "storage.StorageFault",
          "rats.transport.PahoConnection",
          "device.tasks.InTheWay",
          "device.tasks.SightVerdict",
          "coordination.lessons.Experience",
          "coordination.lessons.VainDeeds",
          "ontology.home.OpenChoice",
          "ontology.home.Contradiction",
          "ontology.home.ImpossibleUses",
          "ontology.validation.Nearest",
          "rats.protocol.Rule",
          "rats.protocol.Fields");

  /** What these say is no answer to anybody: descriptions for programs, and stories. */
  private static final Set<String> NO_MESSAGES =
      Set.of(
          "console.api.Api",
          "console.api.HistoryOperations",
          "console.api.PlanOperations",
          "console.api.TrafficOperations",
          "console.members.MemberOperations",
          "console.api.OpenApiDocument",
          "console.Metrics",
          "coordination.story");

  private final CompilationUnitTree unit;
  private final String where;
  private final Map<String, Message> found = new HashMap<>();
  private final Map<String, List<Tree>> declared;

  UnitMessages(CompilationUnitTree unit) {
    this.unit = unit;
    this.declared = Declarations.of(unit);
    String file = Path.of(unit.getSourceFile().getName()).getFileName().toString();
    this.where =
        (unit.getPackageName() + "." + file.replace(".java", ""))
            .replaceFirst("^org\\.maestro\\.", "");
  }

  SortedSet<Message> found() {
    if (PARTS.contains(where)) {
      new Texts(Kinds.PARTS).scan(unit, null);
    } else {
      new Tellings().scan(unit, null);
      if (NO_MESSAGES.stream().noneMatch((where + ".")::startsWith)) {
        new Sentences().scan(unit, null);
      }
    }
    return new TreeSet<>(found.values());
  }

  private void add(String kind, String text) {
    found.putIfAbsent(text, new Message(where, kind, text));
  }

  /** Where something is told. */
  private final class Tellings extends TreeScanner<Void, Void> {
    @Override
    public Void visitAnnotation(AnnotationTree annotation, Void nothing) {
      return null;
    }

    @Override
    public Void visitNewClass(NewClassTree made, Void nothing) {
      String type = made.getIdentifier().toString();
      if (type.endsWith("Exception")) {
        new Texts(type).scan(made.getArguments(), null);
      } else if (type.equals("Fault")) {
        tell(Kinds.FAULTS, type, made.getArguments());
      }
      return super.visitNewClass(made, nothing);
    }

    @Override
    public Void visitMethodInvocation(MethodInvocationTree call, Void nothing) {
      String name = name(call);
      String of =
          call.getMethodSelect() instanceof MemberSelectTree select
              ? select.getExpression().toString()
              : "";
      if (of.equals("LOG")) {
        if (name.equals("warn") || name.equals("error")) {
          new Texts(Kinds.LOG).scan(call.getArguments(), null);
        }
      } else if (of.endsWith("Exception")) {
        new Texts(of).scan(call.getArguments(), null);
      } else if (name.equals("super") && where.endsWith("Exception")) {
        new Texts(where.substring(where.lastIndexOf('.') + 1)).scan(call.getArguments(), null);
      } else if (TOLD.contains(of)) {
        tell(Kinds.FAULTS, "fault", call.getArguments());
      } else if (TELL.contains(name)) {
        tell(WITH_CURE.contains(name) ? Kinds.FAULTS : Kinds.FAILURES, name, call.getArguments());
      }
      return super.visitMethodInvocation(call, nothing);
    }

    private void tell(String kind, String by, List<? extends ExpressionTree> arguments) {
      if (WITH_CURE.contains(by) && arguments.size() > 1) {
        Optional<String> problem = Wording.of(arguments.get(arguments.size() - 2));
        Optional<String> cure = Wording.of(arguments.get(arguments.size() - 1));
        if (problem.isPresent()) {
          add(kind, problem.get() + "; " + cure.orElse(Message.ANYTHING));
          if (cure.isEmpty()) {
            new Texts(kind).scan(arguments.get(arguments.size() - 1), null);
          }
          return;
        }
      }
      new Texts(kind).scan(arguments, null);
    }
  }

  /** Whole sentences that are told in whatever way, but as news in the log. */
  private final class Sentences extends Texts {
    private Sentences() {
      super(Kinds.SENTENCES);
    }

    @Override
    void add(String text) {
      if (Wording.isSentence(text)) {
        super.add(text);
      }
    }

    @Override
    public Void visitMethodInvocation(MethodInvocationTree call, Void nothing) {
      return call.getMethodSelect().toString().startsWith("LOG.")
          ? null
          : super.visitMethodInvocation(call, nothing);
    }
  }

  /** All texts below a place, and what the file's methods and variables named there say. */
  private class Texts extends TreeScanner<Void, Void> {
    private final String kind;
    private final Set<String> followed = new HashSet<>();

    private Texts(String kind) {
      this.kind = kind;
    }

    @Override
    public Void visitAnnotation(AnnotationTree annotation, Void nothing) {
      return null;
    }

    void add(String text) {
      UnitMessages.this.add(kind, text);
    }

    /** It is told by itself. */
    @Override
    public Void visitNewClass(NewClassTree made, Void nothing) {
      return made.getIdentifier().toString().endsWith("Exception")
          ? null
          : super.visitNewClass(made, nothing);
    }

    @Override
    public Void visitBinary(BinaryTree sum, Void nothing) {
      Optional<String> text = sum.getKind() == Tree.Kind.PLUS ? Wording.of(sum) : Optional.empty();
      if (text.isEmpty()) {
        return super.visitBinary(sum, nothing);
      }
      add(text.get());
      operands(sum);
      return null;
    }

    /** What is put into the sum may have words of its own. */
    private void operands(ExpressionTree part) {
      if (part instanceof BinaryTree sum && sum.getKind() == Tree.Kind.PLUS) {
        operands(sum.getLeftOperand());
        operands(sum.getRightOperand());
      } else if (!(part instanceof LiteralTree)) {
        scan(part, null);
      }
    }

    @Override
    public Void visitLiteral(LiteralTree literal, Void nothing) {
      Wording.of(literal).ifPresent(this::add);
      return null;
    }

    @Override
    public Void visitIdentifier(IdentifierTree identifier, Void nothing) {
      follow(identifier.getName().toString());
      return null;
    }

    private void follow(String name) {
      if (followed.add(name)) {
        declared.getOrDefault(name, List.of()).forEach(tree -> scan(tree, null));
      }
    }
  }

  private static String name(MethodInvocationTree call) {
    return call.getMethodSelect() instanceof MemberSelectTree select
        ? select.getIdentifier().toString()
        : call.getMethodSelect().toString();
  }
}
