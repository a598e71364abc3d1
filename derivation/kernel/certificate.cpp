#include "derivation/kernel/certificate.hpp"

#include "derivation/kernel/lemma.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

std::string certificate_prelude() {
    return "Require Import Reals Lra.\nOpen Scope R_scope.\n\n"
           "Lemma by_relation : forall n a b cofactor : R, a = b -> n - cofactor * (a - b) = 0 -> n = 0.\n"
           "Proof. intros n a b cofactor same rest. rewrite same in rest. rewrite <- rest. ring. Qed.\n\n"
           "Lemma part_is_zero : forall factor n rest : R, n = 0 -> rest = 0 -> factor * n + rest = 0.\n"
           "Proof. intros factor n rest zero zero_rest. rewrite zero, zero_rest. ring. Qed.\n\n"
           "Ltac not_zero := let zero := fresh in intro zero;\n"
           "  match goal with H : ?d <> 0 |- False =>\n"
           "    apply H; first [lra | field_simplify_eq; [lra | repeat split; first [assumption | exact PI_neq0]] |\n"
           "                    rewrite zero; field; repeat split; first [assumption | exact PI_neq0]] end.\n"
           "Ltac nonzero := repeat split; first [assumption | exact PI_neq0 | not_zero].\n";
}

std::string functions_prelude() {
    return "Lemma through : forall a b c d : R, c = d -> a = c -> d = b -> a = b.\n"
           "Proof. intros a b c d same left right. rewrite left, same. exact right. Qed.\n\n"
           "Lemma circle : forall x : R, sin x ^ 2 + cos x ^ 2 = 1.\n"
           "Proof. intro x. rewrite <- (sin2_cos2 x). unfold Rsqr. ring. Qed.\n\n"
           "Lemma exp_not_zero : forall x : R, exp x <> 0.\n"
           "Proof. intros x zero. apply (Rlt_irrefl 0). rewrite <- zero at 2. apply exp_pos. Qed.\n\n"
           "Lemma root_squared : forall a : R, 0 <= a -> sqrt a ^ 2 = a.\n"
           "Proof. intros a real. simpl. rewrite Rmult_1_r. apply sqrt_sqrt. exact real. Qed.\n\n"
           "Lemma root_is : forall b v : R, 0 <= v -> b = v * v -> sqrt b = v.\n"
           "Proof. intros b v sign square. rewrite square. apply sqrt_square. exact sign. Qed.\n\n"
           "Ltac addition :=\n"
           "  repeat first [rewrite cos_plus | rewrite sin_plus | rewrite cos_neg | rewrite sin_neg | rewrite cos_PI2 | rewrite "
           "sin_PI2];\n"
           "  field; nonzero.\n"
           "Ltac exponents :=\n"
           "  repeat first [rewrite exp_plus | rewrite Ropp_plus_distr | rewrite Ropp_involutive | rewrite exp_Ropp];\n"
           "  field; repeat split; apply exp_not_zero.\n"
           "Lemma quotient_not_negative : forall a b : R, 0 <= a -> 0 <= b -> b <> 0 -> 0 <= a / b.\n"
           "Proof.\n  intros a b above below not_zero. apply Rmult_le_pos; [exact above |].\n"
           "  left. apply Rinv_0_lt_compat. lra.\nQed.\n\n"
           "Ltac not_negative :=\n"
           "  repeat first [assumption | apply sqrt_pos | exact (Rlt_le _ _ PI_RGT_0) | lra | apply quotient_not_negative |\n"
           "                apply Rmult_le_pos | apply pow_le | solve [nonzero]].\n\n"
           "(* Sums that stand on both sides get a name first, so that neither they nor what they divide by are multiplied out. "
           "*)\n"
           "Ltac name_shared_sums := repeat match goal with |- ?one = ?other =>\n"
           "  match one with\n"
           "  | context [?x + ?y] => match other with context [x + y] =>\n"
           "      let shared := fresh \"shared\" in set (shared := x + y) in *; clearbody shared end\n"
           "  | context [?x - ?y] => match other with context [x - y] =>\n"
           "      let shared := fresh \"shared\" in set (shared := x - y) in *; clearbody shared end\n"
           "  end end.\n"
           "Ltac same_side := first [reflexivity | solve [name_shared_sums; field; nonzero] | field; nonzero].\n";
}

Identity in_generators(const ex& left, const ex& right, const std::vector<Range>& domain, const std::vector<ex>& real) {
    KnownBounds known;
    for (const Range& range : domain) known[range.symbol] = range.bounds;
    Generators generators(known);
    for (const ex& e : real) generators.collect(e, true);
    generators.collect(right, true);
    generators.collect(left, false);
    for (const ex& e : real) (void)generators.rewrite(e, true);
    const ex r = generators.rewrite(right, true), l = generators.rewrite(left, false);
    return {left, right, domain, l, r, generators.names, generators.relations(), generators.functions};
}

Certificate certificate_of(const Identity& identity, const std::string& name, const LeftOut& left_out) {
    return Lemma(identity, left_out).written(name);
}

} // namespace denhartog::derivation
